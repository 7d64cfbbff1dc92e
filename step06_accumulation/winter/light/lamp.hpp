// The part of the scene that shines by itself. What it shines upon is up to light.glsl.
#pragma once

#include "common/program.hpp"
#include "common/scene/scene.hpp"
#include "step06_accumulation/winter/light/daylight.hpp"

class Lamp {
public:
    explicit Lamp(const Scene& scene);

    // Draws it, if it is on, over the same surfaces as they were drawn with the scene.
    void draw(const snow::Light& light);

private:
    SceneMesh glass_;
    Program program_;
};
