// The part of the scene that shines by itself. What it shines upon is up to light.glsl.
#pragma once

#include "common/program.hpp"
#include "step05_collision/solid_scene.hpp"
#include "step06_accumulation/winter/light/daylight.hpp"

class Lamp {
public:
    Lamp();

    // Draws it, if it is on, over the same surfaces as they were drawn with the scene.
    void draw(const snow::Light& light, const SolidScene& solid);

private:
    Program program_;
};
