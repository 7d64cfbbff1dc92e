#include "common/scene/polygon.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <utility>

std::vector<size_t> cut_into_triangles(const std::vector<glm::dvec3>& corners)
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

    std::vector<size_t> triangles, left(corners.size());
    std::iota(left.begin(), left.end(), size_t(0));
    const auto before = [&](size_t i) { return left[(i + left.size() - 1) % left.size()]; };
    const auto after = [&](size_t i) { return left[(i + 1) % left.size()]; };

    // Of each corner: the area of its triangle, > 0 where it points outwards, and what is lost by
    // cutting it off. First come ears, by the length of the cut. Where there is none, as in a
    // polygon without area or one that crosses itself, goes the corner that matters least.
    std::vector<double> size(corners.size());
    std::vector<std::pair<bool, double>> loss(corners.size());
    const auto measure = [&](size_t i) { size[left[i]] = area(before(i), left[i], after(i)); };
    const auto judge = [&](size_t i) {
        const size_t a = before(i), b = left[i], c = after(i);
        const auto holds = [&](size_t p) {
            if (size[p] > 0) return false;  // if it holds any corner, then one that points inwards
            const bool is_corner =
                corners[p] == corners[a] || corners[p] == corners[b] || corners[p] == corners[c];
            return !is_corner && area(a, b, p) >= 0 && area(b, c, p) >= 0 && area(c, a, p) >= 0;
        };
        const bool is_ear = size[b] > 0 && std::none_of(left.begin(), left.end(), holds);
        loss[b] = {!is_ear, is_ear ? glm::distance(corners[a], corners[c]) : std::abs(size[b])};
    };
    const auto judge_all = [&] {
        for (size_t i = 0; i < left.size(); ++i) judge(i);
    };
    const auto find_least = [&] {
        return std::min_element(left.begin(), left.end(),
                                [&](size_t p, size_t q) { return loss[p] < loss[q]; });
    };

    for (size_t i = 0; i < left.size(); ++i) measure(i);
    judge_all();
    bool all_are_judged = true;  // since the last ear was cut off
    while (left.size() >= 3) {
        auto ear = find_least();
        if (loss[*ear].first && !all_are_judged) {
            judge_all();
            all_are_judged = true;
            ear = find_least();
        }
        const auto place = size_t(ear - left.begin());
        triangles.insert(triangles.end(), {before(place), left[place], after(place)});
        if (!loss[*ear].first) all_are_judged = false;
        left.erase(ear);
        // Its neighbours have other triangles now. That any other corner has become an ear is so
        // rare that it is looked for only when there is no ear left.
        const size_t neighbours[] = {(place + left.size() - 1) % left.size(), place % left.size()};
        for (const size_t i : neighbours) measure(i);
        for (const size_t i : neighbours) judge(i);
    }
    return triangles;
}
