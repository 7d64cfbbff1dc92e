#include "common/harness/tour.hpp"

#define GLM_ENABLE_EXPERIMENTAL
#include <algorithm>
#include <cmath>
#include <glm/gtc/constants.hpp>
#include <glm/gtx/spline.hpp>

// Smooth, and through every point.
Pose tour(float seconds)
{
    constexpr int count = 12;
    static const Pose points[count] = {
        {{7.2f, 3.2f, 8.6f}, {0.0f, 1.2f, 1.0f}},      // all of it
        {{2.4f, 1.7f, 6.4f}, {-0.8f, 0.8f, 3.4f}},     // past the table
        {{-2.6f, 1.7f, 7.8f}, {-5.0f, 1.3f, 4.5f}},    // and the bin
        {{-6.0f, 1.6f, 5.8f}, {-6.4f, 1.5f, 0.5f}},    // into the arcade
        {{-6.7f, 1.6f, 1.4f}, {-4.6f, 1.5f, -3.0f}},   // along it, the tree behind its arches
        {{-6.8f, 1.6f, -3.4f}, {-4.0f, 1.5f, -5.2f}},  // round its corner
        {{-5.4f, 1.6f, -6.7f}, {-0.8f, 1.5f, -5.4f}}, {{-1.2f, 1.6f, -6.7f}, {2.8f, 1.5f, -4.4f}},
        {{1.8f, 1.7f, -4.4f}, {5.2f, 1.9f, -3.6f}},  // out of it, towards the lamp
        {{4.6f, 2.1f, -1.8f}, {4.6f, 2.1f, -5.0f}},  // round the lamp
        {{7.6f, 2.6f, -1.6f}, {1.6f, 1.6f, -2.2f}},  // with the fountain and the tree behind
        {{8.4f, 3.0f, 4.2f}, {0.0f, 1.4f, 0.6f}},    // and back past the other table
    };
    const float position = std::fmod(seconds / tour_seconds, 1.0f) * count;
    const float t = position - std::floor(position);
    const auto point = [&](int ahead) { return points[(int(position) + ahead + count) % count]; };
    const auto spline = [&](glm::vec3 Pose::*end) {
        return glm::catmullRom(point(-1).*end, point(0).*end, point(1).*end, point(2).*end, t);
    };
    return {spline(&Pose::eye), spline(&Pose::target)};
}

// A position on the circle, as high above the terrain as keeps clear of it, and smooth: the mean
// over some way before and behind of the highest around.
static glm::vec3 above(const Terrain& terrain, float radius, float turn)
{
    constexpr int samples = 64;
    constexpr float clearance = 4, around = 8, smooth = 20;  // m
    float height = 0;
    for (int i = -samples; i <= samples; ++i) {
        const float angle = turn + float(i) / samples * smooth / radius;
        height += terrain.highest(radius * glm::vec2(std::sin(angle), std::cos(angle)), around);
    }
    return {radius * std::sin(turn), clearance + height / (2 * samples + 1),
            radius * std::cos(turn)};
}

Pose tour_above(const Terrain& terrain, float seconds)
{
    const float radius = std::max(0.33f * terrain.half_size, 10.0f);  // m
    const float turn = glm::two_pi<float>() * std::fmod(seconds / tour_seconds, 1.0f);
    const glm::vec3 eye = above(terrain, radius, turn);
    glm::vec3 target = above(terrain, 0.4f * radius, turn + 0.7f);  // ahead, and into the circle
    target.y -= 3;  // down a little: rather the ground than the sky
    return {eye, target};
}
