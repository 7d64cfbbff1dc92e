#include "common/scene/scene.hpp"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <iostream>
#include <map>
#include <numeric>
#include <stdexcept>
#include <utility>

#include "common/scene/obj.hpp"

using glm::dvec3;
using glm::vec2;
using glm::vec3;

namespace {

// How to move the scene to the middle, and to scale it into its box unless it keeps its metres.
Placement fit(const Obj& obj, bool in_metres)
{
    const dvec3 room = dvec3(16, 6, 16) / (obj.most - obj.least);  // m, against the size there
    const double factor = in_metres ? 1 : std::min({room.x, room.y, room.z});
    if (!(factor > 0 && factor < INFINITY)) throw std::runtime_error("its vertices are one point");
    const dvec3 middle = 0.5 * (obj.least + obj.most);
    return {factor, {middle.x, obj.least.y, middle.z}};
}

// Along its normal, or if it is not flat, that of the plane in which it covers most (Newell's);
// twice as long as its area there, m2.
dvec3 area_vector(const Polygon& polygon)
{
    dvec3 sum(0);
    const dvec3 a = polygon.corners[0].position();
    for (size_t i = 1; i + 1 < polygon.corners.size(); ++i)
        sum += glm::cross(polygon.corners[i].position() - a, polygon.corners[i + 1].position() - a);
    return sum;
}

// Turns over what would carry its snow below: sheets that face down, bodies that are inside out.
void orient(Obj& obj)
{
    // A surface is all polygons that have points in common. Each point knows another of its
    // surface, and so on until the last, which knows itself.
    std::vector<size_t> next(obj.points);
    std::iota(next.begin(), next.end(), size_t(0));
    const auto last = [&](size_t point) {
        while (next[point] != point) point = next[point] = next[next[point]];
        return point;
    };
    struct Surface {
        dvec3 origin;                             // one of its points
        double upward = 0, area = 0, volume = 0;  // m2, m2 and m3, times 2, 2 and 6
    };
    std::vector<Surface> surfaces(obj.points);  // at their last points
    for (const Polygon& polygon : obj.polygons) {
        for (const Corner& corner : polygon.corners) {
            next[last(corner.index)] = last(polygon.corners[0].index);
            surfaces[corner.index].origin = corner.vertex.position;
        }
    }
    for (const Polygon& polygon : obj.polygons) {
        Surface& surface = surfaces[last(polygon.corners[0].index)];
        const dvec3 front = area_vector(polygon);
        surface.upward += front.y;
        surface.area += glm::length(front);
        surface.volume += glm::dot(polygon.corners[0].position() - surface.origin, front);
    }
    for (Polygon& polygon : obj.polygons) {
        const Surface& surface = surfaces[last(polygon.corners[0].index)];
        const bool is_sheet = std::abs(surface.upward) > 0.1 * surface.area;        // and no body
        if (is_sheet ? surface.upward < 0 : surface.volume < -1e-5 * surface.area)  // or rounding
            std::reverse(polygon.corners.begin() + 1, polygon.corners.end());
    }
}

// Cuts off one ear after the other, a corner that points outwards and whose triangle holds no other
// (Meisters 1975, "Polygons have ears"); first the one with the shortest cut, against slivers.
std::vector<Polygon> cut_into_triangles(Polygon polygon)
{
    // > 0 where a, b, c turn left, as the polygon as a whole does.
    const auto turn = [front = area_vector(polygon)](dvec3 a, dvec3 b, dvec3 c) {
        return glm::dot(front, glm::cross(b - a, c - a));
    };
    std::vector<Polygon> triangles;
    std::vector<Corner>& left = polygon.corners;
    for (size_t count = left.size(); count >= 3; --count) {
        const auto at = [&](size_t i) { return left[i % count]; };
        std::pair<double, size_t> ear{INFINITY, 0};  // the length of its cut, and its index
        for (size_t i = 0; i < count; ++i) {
            const dvec3 a = at(i + count - 1).position(), b = at(i).position(),
                        c = at(i + 1).position();
            const auto holds = [&](dvec3 p) {
                return turn(a, b, p) > 0 && turn(b, c, p) > 0 && turn(c, a, p) > 0;
            };
            if (turn(a, b, c) > 0 && std::ranges::none_of(left, holds, &Corner::position))
                ear = std::min(ear, std::pair(glm::distance(a, c), i));
        }
        const size_t i = ear.second;
        triangles.push_back({{at(i + count - 1), at(i), at(i + 1)}, 0, 0});
        left.erase(left.begin() + ptrdiff_t(i));
    }
    return triangles;
}

// The triangles of polygons whose materials come one after the other.
Scene build(const Obj& obj)
{
    std::map<std::pair<unsigned, size_t>, dvec3> smooth;  // normals by smoothing group and point
    for (const Polygon& polygon : obj.polygons) {
        for (const Corner& corner : polygon.corners)
            smooth[{polygon.smoothing, corner.index}] += area_vector(polygon);
    }
    const auto of_length_1 = [](dvec3 direction, dvec3 otherwise) {
        return vec3(direction == dvec3(0) ? otherwise : glm::normalize(direction));
    };
    Scene scene;
    using Numbers = std::array<float, 11>;
    std::map<Numbers, uint32_t> indices;  // of the vertices
    for (size_t last_material = SIZE_MAX; const Polygon& polygon : obj.polygons) {
        if (polygon.material != std::exchange(last_material, polygon.material))
            scene.submeshes.push_back({obj.materials[polygon.material], scene.indices.size(), 0});
        for (const Polygon& triangle : cut_into_triangles(polygon)) {
            const vec3 flat = of_length_1(area_vector(triangle), dvec3(0, 1, 0));
            for (auto [point, ignored, vertex] : triangle.corners) {
                if (vertex.normal == vec3(0) && polygon.smoothing > 0)
                    vertex.normal = smooth[{polygon.smoothing, point}];
                vertex.normal = of_length_1(vertex.normal, flat);
                if (glm::dot(vertex.normal, flat) < 0) vertex.normal = -vertex.normal;
                const auto [index, is_new] =
                    indices.insert({std::bit_cast<Numbers>(vertex), uint32_t(indices.size())});
                if (is_new) scene.vertices.push_back(vertex);
                scene.indices.push_back(index->second);
            }
            scene.submeshes.back().count += 3;
        }
    }
    return scene;
}

}  // namespace

Scene load_scene(const std::filesystem::path& path, char up, const Placement* other, bool in_metres)
try {
    if (path == "none") return {};
    Obj obj = read_obj(path, up);
    const Placement placement = other != nullptr ? *other : fit(obj, in_metres);
    // Farther away, voxels would be too large for what is drawn, and the camera would see nothing.
    const float farthest = in_metres ? 1000 : 100;  // m
    for (Polygon& polygon : obj.polygons) {
        for (auto& [index, point, vertex] : polygon.corners) {
            vertex.position = placement.factor * (point - placement.foot);
            if (!(glm::length(vertex.position) <= farthest))
                throw std::runtime_error("it reaches too far (--metres scales nothing, and two "
                                         "scenes must have the same coordinates)");
        }
    }
    orient(obj);
    std::ranges::stable_sort(obj.polygons, {}, &Polygon::material);
    Scene scene = build(obj);
    scene.placement = placement;
    std::cout << "scene " << path.filename().string() << ": " << scene.indices.size() / 3
              << " triangles, scaled by " << placement.factor << "; their " << scene.indices.size()
              << " corners share " << scene.vertices.size() << " vertices" << std::endl;
    return scene;
} catch (const std::runtime_error& error) {
    throw std::runtime_error("cannot use scene " + path.string() + ": " + error.what());
}

Terrain terrain_of(const Scene& scene)
{
    Terrain terrain;
    float& size = terrain.half_size;
    for (const auto& [p, normal, colour, uv] : scene.vertices)
        size = std::max({size, std::abs(p.x), std::abs(p.z)});
    for (size_t i = 0; i < scene.indices.size(); i += 3) {
        const vec3 a = scene.corner(i).position, b = scene.corner(i + 1).position,
                   c = scene.corner(i + 2).position;
        const vec3 least = glm::min(a, glm::min(b, c)), most = glm::max(a, glm::max(b, c));
        const vec3 normal = glm::cross(b - a, c - a);
        const glm::ivec2 first = terrain.square({least.x, least.z}),
                         last = terrain.square({most.x, most.z});
        for (int z = first.y; z <= last.y; ++z) {
            for (int x = first.x; x <= last.x; ++x) {
                // Where in the square the triangle's plane is highest, or all is if it is upright.
                const vec2 low = glm::max(terrain.corner({x, z}), {least.x, least.z}),
                           high = glm::min(terrain.corner({x + 1, z + 1}), {most.x, most.z});
                const vec2 slope = normal.y == 0 ? vec2(0) : -vec2(normal.x, normal.z) / normal.y;
                const vec2 position(slope.x > 0 ? high.x : low.x, slope.y > 0 ? high.y : low.y);
                const float height = a.y + glm::dot(slope, position - vec2(a.x, a.z));
                terrain.raise({x, z}, normal.y == 0 ? most.y : std::clamp(height, least.y, most.y));
            }
        }
    }
    return terrain;
}
