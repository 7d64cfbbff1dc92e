#include "step05_collision/ground.hpp"

#include <algorithm>

namespace {

using glm::vec3;

// Does the scene fill the lowest layer of the grid from column `begin` to before `end`?
bool has_floor(const VoxelGrid& grid, glm::ivec2 begin, glm::ivec2 end)
{
    for (int z = begin.y; z < end.y; ++z) {
        for (int x = begin.x; x < end.x; ++x) {
            if (!grid.solid({x, 0, z})) return false;
        }
    }
    return true;
}

}  // namespace

int ground_square(const VoxelGrid& grid)
{
    constexpr float finest = 0.5f;  // m
    constexpr int most = 64;        // along an edge of the grid, however large the scene
    return std::max({1, int(finest / grid.cell_size), grid.resolution / most});
}

Scene with_ground(Scene scene, const VoxelGrid& grid)
{
    const int step = ground_square(grid);
    if (scene.vertices.empty()) return scene;
    Submesh ground{{}, scene.indices.size(), 0};
    ground.material.colour = ground_colour;
    for (int z = 0; z < grid.resolution; z += step) {
        for (int x = 0; x < grid.resolution; x += step) {
            const glm::ivec2 begin(x, z), end = glm::min(begin + step, grid.resolution);
            // A floor may end anywhere in a voxel: under its rim the ground goes on.
            if (has_floor(grid, begin - step, end + step)) continue;
            const auto first = uint32_t(scene.vertices.size());
            for (const glm::ivec2 corner : {begin, {begin.x, end.y}, end, {end.x, begin.y}}) {
                vec3 position = grid.origin + grid.cell_size * vec3(corner.x, 0, corner.y);
                position.y = ground_height;
                scene.vertices.push_back({position, vec3(0, 1, 0), ground_colour, {}});
            }
            for (const uint32_t corner : {0u, 1u, 2u, 0u, 2u, 3u})
                scene.indices.push_back(first + corner);
        }
    }
    ground.count = scene.indices.size() - ground.first;
    if (ground.count > 0) scene.submeshes.push_back(ground);
    return scene;
}
