// How far the sun sees in every direction: what lies farther away is in shadow.
#pragma once

#include <GL/glew.h>

#include <glm/glm.hpp>
#include <vector>

#include "common/gl_object.hpp"
#include "common/program.hpp"
#include "step05_collision/scene_mesh.hpp"
#include "step06_accumulation/winter/light/daylight.hpp"

class ShadowMap {
public:
    ShadowMap();

    static std::vector<snow::Parameter> parameters();
    inline static bool soft_shadows = true;

    // Draws the map anew if the sun has moved; the scene never does. window: its size, pixels.
    void update(const snow::Light& light, const SceneMesh& mesh, glm::ivec2 window);

    GLuint texture() const { return depth_; }

private:
    GLsizei texels_ = 0;  // along each edge
    GlObject depth_, framebuffer_;
    Program program_;
    glm::vec3 drawn_for_{};
};
