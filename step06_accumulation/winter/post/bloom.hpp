// The glow around what is bright, as lens and eye make it: the frame's light spread out, wider and
// wider, in pictures of half the size each.
#pragma once

#include <GL/glew.h>

#include <glm/glm.hpp>
#include <vector>

#include "common/program.hpp"
#include "step06_accumulation/winter/post/hdr_target.hpp"

class Bloom {
public:
    Bloom();

    // Spreads the light of the frame, with the vertex array that is bound (full_screen.vert).
    // Leaves another framebuffer bound.
    void update(const HdrTarget& frame);

    // The sum of all.
    GLuint texture() const { return levels_.front().colour; }

private:
    struct Level {
        GlObject colour, framebuffer;
        glm::ivec2 size;
    };
    void allocate(glm::ivec2 size);

    Program shrink_, grow_;
    glm::ivec2 size_{};
    std::vector<Level> levels_;
};
