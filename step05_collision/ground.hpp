// The ground beside the scene.
#pragma once

#include "common/scene/scene.hpp"
#include "step05_collision/voxel_grid.hpp"

inline constexpr float ground_height = -0.005f;  // m, so that no floor at y = 0 shares its depth
inline constexpr glm::vec3 ground_colour(0.20f, 0.21f, 0.17f);  // linear: grass in winter

// The edge of the squares that it is made of, in voxels: snow can bend them.
int ground_square(const VoxelGrid& grid);

// The same scene and, as far as the grid reaches, the ground at y = 0 where the scene has no floor:
// flakes land there, and snow that lies there is to be seen. The empty scene stays empty.
Scene with_ground(Scene scene, const VoxelGrid& grid);
