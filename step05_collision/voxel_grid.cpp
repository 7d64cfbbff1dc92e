#include "step05_collision/voxel_grid.hpp"

#include <algorithm>
#include <numeric>
#include <stdexcept>
#include <string>

#include "step05_collision/triangle_box.hpp"

namespace {

using glm::ivec3;
using glm::vec3;

class Octree {
public:
    Octree(const Scene& scene, VoxelGrid& grid) : scene_(scene), grid_(grid)
    {
        std::vector<uint32_t> all(scene.indices.size() / 3);
        std::iota(all.begin(), all.end(), 0);
        divide(ivec3(0), grid.resolution, all);
    }

private:
    // triangles: those that touch the cube of `size` voxels at `corner`.
    void divide(ivec3 corner, int size, const std::vector<uint32_t>& triangles)
    {
        if (triangles.empty()) return;
        if (size == 1) {
            const size_t row = size_t(corner.z) * size_t(grid_.resolution) + size_t(corner.y);
            grid_.words[row * size_t(grid_.resolution / 32) + size_t(corner.x / 32)] |=
                1u << (corner.x % 32);
            return;
        }
        const int half = size / 2;
        std::vector<uint32_t> inside;
        for (int child = 0; child < 8; ++child) {
            const ivec3 child_corner =
                corner + half * ivec3(child & 1, (child >> 1) & 1, child >> 2);
            // A cube larger than a voxel is taken a hair too large, so that rounding cannot hide
            // from it a triangle that touches one of its voxels.
            const float margin = half > 1 ? 1.0001f : 1.0f;
            const vec3 half_size(0.5f * float(half) * grid_.cell_size);
            const vec3 centre = grid_.origin + grid_.cell_size * vec3(child_corner) + half_size;
            inside.clear();
            for (const uint32_t triangle : triangles) {
                const size_t first = 3 * size_t(triangle);
                if (!snow::triangle_touches_box(
                        scene_.corner(first).position, scene_.corner(first + 1).position,
                        scene_.corner(first + 2).position, centre, margin * half_size))
                    continue;
                inside.push_back(triangle);
                if (half == 1) break;  // one is enough for a voxel
            }
            divide(child_corner, half, inside);
        }
    }

    const Scene& scene_;
    VoxelGrid& grid_;
};

}  // namespace

bool VoxelGrid::solid(ivec3 cell) const
{
    if (glm::any(glm::lessThan(cell, ivec3(0))) ||
        glm::any(glm::greaterThanEqual(cell, ivec3(resolution)))) {
        return false;
    }
    const size_t row = size_t(cell.z) * size_t(resolution) + size_t(cell.y);
    return (words[row * size_t(resolution / 32) + size_t(cell.x / 32)] >> (cell.x % 32)) & 1u;
}

VoxelGrid place_grid(const Scene& scene, int resolution)
{
    vec3 minimum(-8, 0, -8), maximum(8, 6, 8);  // m, for the empty scene
    if (!scene.vertices.empty()) minimum = maximum = scene.vertices.front().position;
    for (const Vertex& vertex : scene.vertices) {
        minimum = glm::min(minimum, vertex.position);
        maximum = glm::max(maximum, vertex.position);
    }
    minimum.y = std::min(minimum.y, 0.0f);  // from the ground on, however high all of it stands
    const vec3 size = maximum - minimum;
    VoxelGrid grid{};
    grid.resolution = resolution;
    // One voxel of air on each side. What is smaller than a metre has no smaller ones: a flake
    // would walk through thousands in a step.
    grid.cell_size = std::max({size.x, size.y, size.z, 1.0f}) / float(resolution - 2);
    grid.origin = 0.5f * (minimum + maximum) - 0.5f * float(resolution) * grid.cell_size;
    // A floor at y = 0 is the upper side of the lowest voxels, so that flakes lie on it, not above
    // it.
    grid.origin.y = -0.999f * grid.cell_size;
    grid.words.resize(size_t(resolution) * size_t(resolution) * size_t(resolution) / 32);
    return grid;
}

VoxelGrid voxelise(const Scene& scene, int resolution)
{
    VoxelGrid grid = place_grid(scene, resolution);
    Octree(scene, grid);
    return grid;
}

GlObject upload_voxels(const VoxelGrid& grid)
{
    GLint largest = 0;
    glGetIntegerv(GL_MAX_3D_TEXTURE_SIZE, &largest);
    if (grid.resolution > largest) {
        throw std::runtime_error("--voxels " + std::to_string(grid.resolution) +
                                 ": this card's 3D textures end at " + std::to_string(largest));
    }
    GlObject texture = make_texture();
    glBindTexture(GL_TEXTURE_3D, texture);
    glTexImage3D(GL_TEXTURE_3D, 0, GL_R32UI, grid.resolution / 32, grid.resolution, grid.resolution,
                 0, GL_RED_INTEGER, GL_UNSIGNED_INT, grid.words.data());
    check_memory("the voxels", double(4 * grid.words.size()));
    glTexParameteri(GL_TEXTURE_3D, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
    glTexParameteri(GL_TEXTURE_3D, GL_TEXTURE_MAG_FILTER, GL_NEAREST);
    return texture;
}
