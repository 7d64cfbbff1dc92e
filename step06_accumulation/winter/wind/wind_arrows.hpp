// The wind as arrows, one in every few cells of its field.
#pragma once

#include "common/program.hpp"
#include "step04_transform_feedback/no_vertices.hpp"
#include "step05_collision/solid_scene.hpp"
#include "step06_accumulation/winter/wind/wind_field.hpp"

class WindArrows {
public:
    WindArrows();

    // tick: time steps made since the first flake.
    void draw(const WindField& wind, const SolidScene& solid, const snow::Weather& weather,
              unsigned tick);

private:
    Permutations program_;
    NoVertices vao_;  // the shader knows its corners
};
