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
        const vec3 normal = glm::cross(b - a, c - a);
        const ivec2 first = terrain.square({least.x, least.z}),
                    last = terrain.square({most.x, most.z});
        for (int z = first.y; z <= last.y; ++z) {
            for (int x = first.x; x <= last.x; ++x) {
                // Where in the square the triangle's plane is highest, or all is if it is upright.
                const vec2 low = glm::max(terrain.corner({x, z}), {least.x, least.z}),
                           high = glm::min(terrain.corner({x + 1, z + 1}), {most.x, most.z});
                const vec2 slope = normal.y == 0 ? vec2(0) : -vec2(normal.x, normal.z) / normal.y;
                const vec2 place(slope.x > 0 ? high.x : low.x, slope.y > 0 ? high.y : low.y);
                const float height = a.y + glm::dot(slope, place - vec2(a.x, a.z));
                terrain.raise({x, z}, normal.y == 0 ? most.y : std::clamp(height, least.y, most.y));
            }
        }
    }
    return terrain;
}
