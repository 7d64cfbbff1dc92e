// How much of the sky each place in the scene sees: below a roof or beside a wall it is darker,
// shadow or not.
#pragma once

#include "common/gl_object.hpp"
#include "step05_collision/voxel_grid.hpp"

class AmbientOcclusion {
public:
    // Looks from every cell of a coarse grid into many directions, once.
    explicit AmbientOcclusion(const VoxelGrid& grid);

    // What it has seen, as light.glsl reads it.
    GLuint texture() const { return texture_; }

private:
    GlObject texture_;
};
