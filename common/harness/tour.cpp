#include "common/harness/tour.hpp"

#include <algorithm>
#include <array>
#include <cmath>

// Smooth, and through every point.
Pose tour(float seconds)
{
    using glm::vec3;
    constexpr int count = 12;
    static const std::array<Pose, count> points = {{
        {{7.2f, 3.2f, 8.6f}, {0.0f, 1.2f, 1.0f}},      // all of it
        {{2.4f, 1.7f, 6.4f}, {-0.8f, 0.8f, 3.4f}},     // past the table
        {{-2.6f, 1.7f, 7.8f}, {-5.0f, 1.3f, 4.5f}},    // and the bin
        {{-6.0f, 1.6f, 5.8f}, {-6.4f, 1.5f, 0.5f}},    // into the arcade
        {{-6.7f, 1.6f, 1.4f}, {-4.6f, 1.5f, -3.0f}},   // along it, the tree behind its arches
        {{-6.8f, 1.6f, -3.4f}, {-4.0f, 1.5f, -5.2f}},  // round its corner
        {{-5.4f, 1.6f, -6.7f}, {-0.8f, 1.5f, -5.4f}},
        {{-1.2f, 1.6f, -6.7f}, {2.8f, 1.5f, -4.4f}},
        {{1.8f, 1.7f, -4.4f}, {5.2f, 1.9f, -3.6f}},  // out of it, towards the lamp
        {{4.6f, 2.1f, -1.8f}, {4.6f, 2.1f, -5.0f}},  // round the lamp
        {{7.6f, 2.6f, -1.6f}, {1.6f, 1.6f, -2.2f}},  // with the fountain and the tree behind
        {{8.4f, 3.0f, 4.2f}, {0.0f, 1.4f, 0.6f}},    // and back past the other table
    }};
    const float position = std::fmod(seconds / tour_seconds, 1.0f) * count;
    const float t = position - std::floor(position);
    const auto point = [&](int ahead) -> const Pose& {
        return points[size_t(int(position) + ahead + count) % count];
    };
    const auto spline = [&](vec3 Pose::*end) {
        const vec3 a = point(-1).*end, b = point(0).*end, c = point(1).*end, d = point(2).*end;
        return b + 0.5f * t *
                       (c - a +
                        t * (2.0f * a - 5.0f * b + 4.0f * c - d + t * (3.0f * (b - c) + d - a)));
    };
    return {spline(&Pose::eye), spline(&Pose::target)};
}

namespace {

// A position on the circle, as high above the terrain as keeps clear of it, and smooth: the mean
// over some way before and behind of the highest around.
glm::vec3 above(const Terrain& terrain, float radius, float turn)
{
    constexpr int samples = 64;
    constexpr float clearance = 4, around = 8, smooth = 20;  // m
    const auto position = [&](float angle) {
        return radius * glm::vec2(std::sin(angle), std::cos(angle));
    };
    float height = 0;
    for (int i = -samples; i <= samples; ++i) {
        const float fraction = float(i) / samples;
        height += terrain.highest(position(turn + fraction * smooth / radius), around);
    }
    const glm::vec2 here = position(turn);
    return {here.x, clearance + height / (2 * samples + 1), here.y};
}

}  // namespace

Pose tour_above(const Terrain& terrain, float seconds)
{
    const float radius = std::max(0.33f * terrain.half_size, 10.0f);  // m
    const float turn = 6.2831853f * std::fmod(seconds / tour_seconds, 1.0f);
    const glm::vec3 eye = above(terrain, radius, turn);
    glm::vec3 target = above(terrain, 0.4f * radius, turn + 0.7f);  // ahead, and into the circle
    target.y -= 3;  // down a little: rather the ground than the sky
    return {eye, target};
}
