// The frame's light as colours of a screen: exposure, a curve and the glow around what is bright.
#pragma once

#include <vector>

#include "common/program.hpp"
#include "common/weather.hpp"
#include "step04_transform_feedback/no_vertices.hpp"
#include "step06_accumulation/winter/post/bloom.hpp"
#include "step06_accumulation/winter/post/linear_frame.hpp"

class Tone {
public:
    Tone();

    static std::vector<snow::Parameter> parameters();
    inline static float exposure = 1;

    // Draws the frame into the window, and the glow over it, if there is one.
    void draw(const LinearFrame& frame, const Bloom* bloom);

private:
    Program plain_, glowing_;
    NoVertices vao_;  // the shader knows its corners
};
