#include "common/scene/normals.hpp"

#include <unordered_map>

namespace {

using glm::vec3;

// Along its normal, and as long as it has area (Newell's, for one that is not flat).
vec3 across(const Polygon& polygon, const std::vector<vec3>& points)
{
    const auto corner = [&](size_t k) { return points[polygon.corners[k].point]; };
    vec3 sum(0);
    for (size_t k = 1; k + 1 < polygon.corners.size(); ++k)
        sum += 0.5f * glm::cross(corner(k) - corner(0), corner(k + 1) - corner(0));
    return sum;
}

// Whoever has turned the polygon may have left its normals behind.
void turn_to_front(Polygon& polygon, std::vector<vec3>& normals, vec3 front)
{
    float before = 0;  // > 0: the normals are on the front
    for (Corner& corner : polygon.corners) {
        if (corner.normal == Corner::none) continue;
        const float length = glm::length(normals[corner.normal]);
        if (length > 0)
            before += glm::dot(front, normals[corner.normal]) / length;
        else
            corner.normal = Corner::none;
    }
    if (before >= 0) return;
    for (Corner& corner : polygon.corners) {
        if (corner.normal == Corner::none) continue;
        const vec3 turned = -normals[corner.normal];
        corner.normal = uint32_t(normals.size());
        normals.push_back(turned);
    }
}

}  // namespace

void complete_normals(std::vector<Polygon>& polygons, std::vector<vec3>& normals,
                      const std::vector<vec3>& points)
{
    // Of each smoothing group and point: the number of their normal.
    std::unordered_map<uint64_t, uint32_t> smooth;
    for (Polygon& polygon : polygons) {
        const vec3 front = across(polygon, points);
        turn_to_front(polygon, normals, front);
        if (polygon.smoothing == 0) continue;
        for (Corner& corner : polygon.corners) {
            if (corner.normal != Corner::none) continue;
            const uint64_t key = uint64_t(polygon.smoothing) << 32 | corner.point;
            const auto [place, is_new] = smooth.emplace(key, uint32_t(normals.size()));
            if (is_new) normals.emplace_back(0);
            corner.normal = place->second;
            normals[corner.normal] += front;
        }
    }
}
