// How high the scene stands where: the highest of it in each of 128 x 128 squares around the
// middle.
#pragma once

#include <algorithm>
#include <glm/glm.hpp>
#include <vector>

struct Terrain {
    static constexpr int squares = 128;  // along each edge

    float half_size = 1;  // m, from the middle to the edge; at least 1
    // The height of each square, m: row by row along x, from the least z on.
    std::vector<float> heights = std::vector<float>(squares * squares);

    // The square in which a position (x, z) lies, m, or the nearest.
    glm::ivec2 square(glm::vec2 position) const
    {
        const glm::vec2 uv = 0.5f + 0.5f * position / half_size;
        return glm::clamp(glm::ivec2(glm::floor(uv * float(squares))), 0, squares - 1);
    }
    // The corner of least x and z of a square, m.
    glm::vec2 corner(glm::ivec2 square) const
    {
        return (2.0f * glm::vec2(square) / float(squares) - 1.0f) * half_size;
    }
    void raise(glm::ivec2 square, float height)
    {
        float& known = heights[size_t(square.y * squares + square.x)];
        known = std::max(known, height);
    }

    // The highest of the scene within `around` m of a position along x and z; 0 if nothing is
    // there.
    float highest(glm::vec2 position, float around) const
    {
        const glm::ivec2 first = square(position - around), last = square(position + around);
        float best = 0;
        for (int z = first.y; z <= last.y; ++z) {
            for (int x = first.x; x <= last.x; ++x)
                best = std::max(best, heights[size_t(z * squares + x)]);
        }
        return best;
    }
};
