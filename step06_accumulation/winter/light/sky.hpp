// The sky, behind everything else.
#pragma once

#include <vector>

#include "common/program.hpp"
#include "common/weather.hpp"
#include "step04_transform_feedback/no_vertices.hpp"
#include "step06_accumulation/winter/light/daylight.hpp"

class Sky {
public:
    Sky();

    static std::vector<snow::Parameter> parameters();
    inline static bool sky = true;

    void draw(const snow::Light& light);

private:
    Program day_, night_;
    NoVertices vao_;  // the shader knows its corners
};
