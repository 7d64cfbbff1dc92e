// Which parts of space a scene fills: a cube of resolution^3 voxels, one bit each.
#pragma once

#include <cstdint>
#include <glm/glm.hpp>
#include <vector>

#include "common/gl_object.hpp"
#include "common/scene/scene.hpp"
#include "common/snow.hpp"

namespace snow {
#include "step05_collision/grid.glsl"
static_assert(sizeof(Grid) == 32, "the layout std140 gives it");
}  // namespace snow

struct VoxelGrid {
    int resolution;               // voxels along each edge, a power of two, at least 32
    glm::vec3 origin;             // m, the corner of least x, y and z
    float cell_size;              // m, edge of a voxel
    std::vector<uint32_t> words;  // 32 voxels along x each: resolution^3 / 8 bytes

    bool solid(glm::ivec3 cell) const;  // false outside the grid
};

// Where the grid of a scene lies, with nothing in it yet.
VoxelGrid place_grid(const Scene& scene, int resolution);

// Marks every voxel that a triangle of the scene touches, by dividing space as an octree does: a
// cube that no triangle touches is done with, any other is divided into eight, down to single
// voxels.
VoxelGrid voxelise(const Scene& scene, int resolution);

// The grid as an R32UI 3D texture of resolution/32 x resolution x resolution words, bound to
// GL_TEXTURE_3D. Throws std::runtime_error if the card cannot hold it.
GlObject upload_voxels(const VoxelGrid& grid);
