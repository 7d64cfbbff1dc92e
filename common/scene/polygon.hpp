// Divides polygons into triangles, those with corners that point inwards too.
#pragma once

#include <algorithm>
#include <cmath>
#include <glm/glm.hpp>
#include <limits>
#include <numeric>
#include <utility>
#include <vector>

// Cuts off one ear after the other: a corner that points outwards and whose triangle holds no other
// corner (Meisters 1975, "Polygons have ears"). The ear with the shortest cut goes first, which
// avoids slivers. Returns the indices of n - 2 triangles that run the same way around as `corners`;
// so it does for polygons that no triangles could fill, without area or crossing themselves.
inline std::vector<size_t> cut_into_triangles(const std::vector<glm::dvec3>& corners)
{
    using glm::dvec3;
    // Newell's normal: that of the plane in which the polygon, perhaps not flat, covers most.
    dvec3 normal(0);
    for (size_t i = 1; i + 1 < corners.size(); ++i) {
        normal += glm::cross(corners[i] - corners[0], corners[i + 1] - corners[0]);
    }
    // Proportional to the area of a triangle as seen in that plane: > 0 where it turns left, as the
    // polygon as a whole does.
    const auto area = [&](size_t a, size_t b, size_t c) {
        return glm::dot(normal, glm::cross(corners[b] - corners[a], corners[c] - corners[a]));
    };

    std::vector<size_t> triangles, left(corners.size()), inward;
    std::iota(left.begin(), left.end(), size_t(0));
    while (left.size() >= 3) {
        const auto before = [&](size_t i) { return left[(i + left.size() - 1) % left.size()]; };
        const auto after = [&](size_t i) { return left[(i + 1) % left.size()]; };
        // If any corner lies in an ear's triangle, then one of these does.
        inward.clear();
        for (size_t i = 0; i < left.size(); ++i) {
            if (area(before(i), left[i], after(i)) <= 0) inward.push_back(left[i]);
        }

        // First come ears, by the length of the cut. Where there is none, as in a polygon without
        // area or one that crosses itself, goes the corner that matters least.
        std::pair<bool, double> least{true, std::numeric_limits<double>::infinity()};
        size_t ear = 0;
        for (size_t i = 0; i < left.size(); ++i) {
            const size_t a = before(i), b = left[i], c = after(i);
            const auto holds = [&](size_t p) {
                const bool is_corner = corners[p] == corners[a] || corners[p] == corners[b] ||
                                       corners[p] == corners[c];
                return !is_corner && area(a, b, p) >= 0 && area(b, c, p) >= 0 && area(c, a, p) >= 0;
            };
            const double size = area(a, b, c);
            const bool is_ear = size > 0 && std::none_of(inward.begin(), inward.end(), holds);
            const std::pair<bool, double> loss{
                !is_ear, is_ear ? glm::distance(corners[a], corners[c]) : std::abs(size)};
            if (loss < least) {
                least = loss;
                ear = i;
            }
        }
        triangles.insert(triangles.end(), {before(ear), left[ear], after(ear)});
        left.erase(left.begin() + std::ptrdiff_t(ear));
    }
    return triangles;
}
