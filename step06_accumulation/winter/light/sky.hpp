// The sky, and the field around the scene, behind everything else.
#pragma once

#include <vector>

#include "common/program.hpp"
#include "common/weather.hpp"
#include "step04_transform_feedback/no_vertices.hpp"

class Sky {
public:
    Sky();

    static std::vector<snow::Parameter> parameters();
    inline static float sky = 1;  // a switch

    Program program;  // wants the textures of light.glsl
    void draw();

private:
    NoVertices vao_;  // the shader knows its corners
};
