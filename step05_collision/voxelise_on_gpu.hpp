// The voxel grid of a scene, made by the GPU: for those whose driver has OpenGL 4.2.
#pragma once

#include "step05_collision/voxel_grid.hpp"

// Marks the same voxels as voxelise does on the CPU, but for those that a triangle only touches,
// where the two round differently: every triangle is drawn, and each of its pixels marks the voxels
// behind it that it touches. Throws std::runtime_error if OpenGL lacks what that needs.
VoxelGrid voxelise_on_gpu(const Scene& scene, int resolution);
