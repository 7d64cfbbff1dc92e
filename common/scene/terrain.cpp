#include "common/scene/terrain.hpp"

#include <algorithm>
#include <cmath>

using glm::ivec2;
using glm::vec2;
using glm::vec3;

Terrain terrain_of(const Scene& scene)
{
    Terrain terrain;
    for (const Vertex& vertex : scene.vertices) {
        terrain.half_size =
            std::max({terrain.half_size, std::abs(vertex.position.x), std::abs(vertex.position.z)});
    }
    for (size_t i = 0; i < scene.indices.size(); i += 3) {
        const vec3 a = scene.corner(i).position, b = scene.corner(i + 1).position,
                   c = scene.corner(i + 2).position;
        const vec3 least = glm::min(a, glm::min(b, c)), most = glm::max(a, glm::max(b, c));
        const ivec2 first = terrain.square({least.x, least.z}),
                    last = terrain.square({most.x, most.z});
        for (int z = first.y; z <= last.y; ++z) {
            for (int x = first.x; x <= last.x; ++x) terrain.raise({x, z}, most.y);
        }
    }
    return terrain;
}
