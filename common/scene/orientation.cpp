#include "common/scene/orientation.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>
#include <set>
#include <utility>

namespace {

using glm::dvec3;
using glm::vec3;

// For each point the first in the same place: files often have one for each polygon that meets
// there.
std::vector<uint32_t> weld(const std::vector<vec3>& points)
{
    const auto place = [&](uint32_t i) {
        return std::array{points[i].x, points[i].y, points[i].z};
    };
    std::vector<uint32_t> order(points.size()), first(points.size());
    std::iota(order.begin(), order.end(), 0);
    std::sort(order.begin(), order.end(), [&](uint32_t i, uint32_t j) {
        return std::pair(place(i), i) < std::pair(place(j), j);
    });
    for (size_t k = 0; k < order.size(); ++k) {
        const bool is_new = k == 0 || place(order[k]) != place(order[k - 1]);
        first[order[k]] = is_new ? order[k] : first[order[k - 1]];
    }
    return first;
}

// Sets of polygons that make one surface. Of two in a set is known whether one must be turned over
// so that both run the same way around. (A union-find forest whose links carry that.)
class Surfaces {
public:
    explicit Surfaces(size_t polygons) : parent_(polygons), differs_(polygons)
    {
        std::iota(parent_.begin(), parent_.end(), size_t(0));
    }

    // The polygon that stands for the set, and whether this one runs the other way around.
    std::pair<size_t, bool> find(size_t polygon)
    {
        bool differs = false;
        while (parent_[polygon] != polygon) {
            const size_t parent = parent_[polygon];
            differs_[polygon] = differs_[polygon] != differs_[parent];
            parent_[polygon] = parent_[parent];  // halves the way for the next who asks
            differs = differs != differs_[polygon];
            polygon = parent_[polygon];
        }
        return {polygon, differs};
    }

    void join(size_t one, size_t other, bool differ)
    {
        const auto [first, first_differs] = find(one);
        const auto [second, second_differs] = find(other);
        if (first == second) return;
        parent_[second] = first;
        differs_[second] = (first_differs != second_differs) != differ;
    }

private:
    std::vector<size_t> parent_;
    std::vector<char> differs_;  // bool: from the parent
};

// Joins those that share edges. Two polygons of one surface run along an edge in both directions;
// if they run in one, either must be turned over, unless other edges have told already.
Surfaces find_surfaces(const std::vector<Polygon>& polygons, const std::vector<uint32_t>& welded)
{
    struct Edge {
        std::array<uint32_t, 2> ends;  // the smaller first
        uint32_t polygon;
        bool is_forward;  // from the first end to the second
    };
    std::vector<Edge> edges;
    for (size_t i = 0; i < polygons.size(); ++i) {
        uint32_t from = welded[polygons[i].corners.back().point];
        for (const Corner& corner : polygons[i].corners) {
            const uint32_t to = welded[corner.point];
            if (from != to)
                edges.push_back({{std::min(from, to), std::max(from, to)}, uint32_t(i), from < to});
            from = to;
        }
    }
    std::stable_sort(edges.begin(), edges.end(),
                     [](const Edge& a, const Edge& b) { return a.ends < b.ends; });
    Surfaces surfaces(polygons.size());
    std::vector<std::pair<uint32_t, uint32_t>> opposed;
    for (auto edge = edges.begin(), next = edge; edge != edges.end(); edge = next) {
        next = std::find_if(edge, edges.end(), [&](const Edge& e) { return e.ends != edge->ends; });
        const bool both_ways = std::any_of(
            edge, next, [&](const Edge& e) { return e.is_forward != edge->is_forward; });
        if (both_ways) {
            for (auto other = edge + 1; other != next; ++other)
                surfaces.join(edge->polygon, other->polygon, false);
        } else if (next - edge == 2) {  // of more, nothing says which belong together
            opposed.emplace_back(edge->polygon, (edge + 1)->polygon);
        }
    }
    for (const auto& [one, other] : opposed) surfaces.join(one, other, true);
    return surfaces;
}

// Of polygons with the same corners, whichever way around they run, leaves the first.
void remove_copies(std::vector<Polygon>& polygons, const std::vector<uint32_t>& welded)
{
    std::set<std::vector<uint32_t>> seen;
    std::erase_if(polygons, [&](const Polygon& polygon) {
        std::vector<uint32_t> ring;
        for (const Corner& corner : polygon.corners) ring.push_back(welded[corner.point]);
        std::rotate(ring.begin(), std::min_element(ring.begin(), ring.end()), ring.end());
        if (ring[1] > ring.back()) std::reverse(ring.begin() + 1, ring.end());
        return !seen.insert(std::move(ring)).second;
    });
}

// What is known of a surface, or a part of it, from sums over its triangles.
struct Measures {
    dvec3 area{0};          // m2, along the normals
    double whole_area = 0;  // m2, whichever way they face
    double volume = 0;      // m3, between the triangles and the origin; behind them: > 0
    dvec3 moment{0};        // m3, of the whole area: its middle, times it

    void add(dvec3 a, dvec3 b, dvec3 c, double sign)
    {
        const dvec3 across = 0.5 * glm::cross(b - a, c - a);
        area += sign * across;
        whole_area += glm::length(across);
        volume += sign * glm::dot(a, across) / 3.0;
        moment += glm::length(across) * (a + b + c) / 3.0;
    }

    bool faces_the_wrong_way() const
    {
        if (whole_area == 0) return false;
        const double upward = area.y / whole_area;  // 1: all faces up
        if (std::abs(upward) > 0.1) return upward < 0;
        // The volume is measured from the middle, or it would depend on where an open one lies.
        const double inside = volume - glm::dot(moment / whole_area, area) / 3.0;
        return inside < -1e-6 * std::pow(whole_area, 1.5);  // not for what is flat but for rounding
    }
};

}  // namespace

void orient(std::vector<Polygon>& polygons, const std::vector<vec3>& points)
{
    const std::vector<uint32_t> welded = weld(points);
    remove_copies(polygons, welded);
    Surfaces surfaces = find_surfaces(polygons, welded);
    std::vector<Measures> measures(polygons.size());  // of each surface, at what stands for it
    for (size_t i = 0; i < polygons.size(); ++i) {
        const auto [surface, differs] = surfaces.find(i);
        const auto corner = [&](size_t k) { return points[polygons[i].corners[k].point]; };
        for (size_t k = 1; k + 1 < polygons[i].corners.size(); ++k)
            measures[surface].add(corner(0), corner(k), corner(k + 1), differs ? -1 : 1);
    }
    for (size_t i = 0; i < polygons.size(); ++i) {
        const auto [surface, differs] = surfaces.find(i);
        if (differs != measures[surface].faces_the_wrong_way())
            std::reverse(polygons[i].corners.begin() + 1, polygons[i].corners.end());
    }
}
