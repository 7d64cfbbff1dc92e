// The ground beside the scene.
#pragma once

#include "common/scene/scene.hpp"
#include "step05_collision/voxel_grid.hpp"

// The same scene and, as far as the grid reaches, the ground at y = 0 where the scene has no floor:
// flakes land there, and snow that lies there is to be seen. The empty scene stays empty.
Scene with_ground(Scene scene, const VoxelGrid& grid);
