// The part of the scene that shines by itself. What it shines upon is up to light.glsl.
#pragma once

#include "common/program.hpp"
#include "step04_transform_feedback/no_vertices.hpp"
#include "step05_collision/solid_scene.hpp"
#include "step06_accumulation/winter/light/daylight.hpp"

class Lamp {
public:
    Lamp();

    // Draws it, shining, over the same surfaces as they were drawn with the scene.
    void draw(const snow::Light& light, const SolidScene& solid);

    // Adds its halo to the frame, whose depth this is.
    void draw_halo(GLuint frame_depth);

private:
    Program program_, halo_;
    NoVertices vao_;  // the shader of the halo knows its corners
};
