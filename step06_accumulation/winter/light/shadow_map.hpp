// How far the sun sees in every direction: what lies farther away is in shadow.
#pragma once

#include <GL/glew.h>

#include <glm/glm.hpp>

#include "common/program.hpp"
#include "step05_collision/solid_scene.hpp"

class ShadowMap {
public:
    ShadowMap();

    // Draws the map anew if the sun has moved; the scene never does. to_sun: see frame.glsl. soft:
    // edges are blended. wide: a scene so large, or seen so closely, that texels would show. Leaves
    // another framebuffer bound.
    void update(glm::vec3 to_sun, const SolidScene& solid, bool soft, bool wide);

    GLuint texture() const { return depth_; }

private:
    GLsizei texels_ = 0;  // along each edge
    GlObject depth_, framebuffer_;
    Program program_;
    glm::vec3 drawn_for_{};
};
