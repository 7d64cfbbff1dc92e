// The part of the scene that shines by itself. What it shines upon is up to light.glsl.
#pragma once

#include <GL/glew.h>

#include "common/program.hpp"
#include "common/scene.hpp"
#include "step06_accumulation/light.hpp"

class Lamp {
public:
    explicit Lamp(const Scene& scene)
        : glass_(scene.lamps), program_({{GL_VERTEX_SHADER, "step06_accumulation/lamp.vert"},
                                         {GL_FRAGMENT_SHADER, "step06_accumulation/lamp.frag"}})
    {}

    // Draws it, if it is on, over the same surfaces as they were drawn with the scene.
    void draw(const snow::Light& light)
    {
        if (light.lamp_is_on == 0) return;
        glEnable(GL_POLYGON_OFFSET_FILL);
        glPolygonOffset(-1, -1);  // a little nearer: the two must not fight over pixels
        program_.use();
        glass_.draw();
        glDisable(GL_POLYGON_OFFSET_FILL);
    }

private:
    SceneMesh glass_;
    Program program_;
};
