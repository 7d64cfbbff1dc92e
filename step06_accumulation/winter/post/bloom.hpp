// The glow around what is bright, as lens and eye make it: the frame's light spread out, wider and
// wider, in pictures of half the size each.
#pragma once

#include <GL/glew.h>

#include <glm/glm.hpp>
#include <vector>

#include "common/program.hpp"
#include "common/weather.hpp"
#include "step04_transform_feedback/no_vertices.hpp"
#include "step06_accumulation/winter/post/linear_frame.hpp"

class Bloom {
public:
    Bloom();

    static std::vector<snow::Parameter> parameters();
    inline static float bloom = 0.06f;  // part of the light that is spread; 0: none

    // Spreads the light of the frame. Leaves another framebuffer bound.
    void update(const LinearFrame& frame);

    // The sum of all.
    GLuint texture() const { return levels_.front().colour; }

private:
    struct Level {
        GlObject colour, framebuffer;
        glm::ivec2 size;
    };
    void allocate(glm::ivec2 size);

    Program shrink_, grow_;
    NoVertices vao_;  // the shader knows its corners
    glm::ivec2 size_{};
    std::vector<Level> levels_;
};
