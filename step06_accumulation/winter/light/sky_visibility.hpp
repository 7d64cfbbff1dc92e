// How much of the sky is seen from everywhere in the scene: below a roof or beside a wall it is
// darker, shadow or not.
#pragma once

#include "common/gl_object.hpp"
#include "step05_collision/voxel_grid.hpp"

// Looks from every cell of a coarse grid into many directions. Returns what was seen as a 3D
// texture, as light.glsl reads it.
GlObject make_sky_visibility(const VoxelGrid& grid);
