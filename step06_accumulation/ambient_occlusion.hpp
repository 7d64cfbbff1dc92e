// How much of the sky each place in the scene sees: below a roof or beside a wall it is darker,
// shadow or not.
#pragma once

#include "common/gl_object.hpp"
#include "step05_collision/voxel_grid.hpp"

class AmbientOcclusion {
public:
    // Looks from every cell of a coarse grid into many directions, once, and binds what it has seen
    // where light.glsl reads it: texture unit 4.
    explicit AmbientOcclusion(const VoxelGrid& grid);

private:
    GlObject texture_;
};
