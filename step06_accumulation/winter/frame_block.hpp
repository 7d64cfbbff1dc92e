// Tells all shaders of the winter, once a frame, where it is seen from and in what light.
#pragma once

#include <glm/glm.hpp>

#include "common/snow.hpp"
#include "common/uniform_block.hpp"
#include "common/window.hpp"
#include "step05_collision/solid_scene.hpp"
#include "step06_accumulation/winter/settings.hpp"

namespace snow {
#include "step06_accumulation/winter/frame.glsl"
static_assert(sizeof(Frame) == 432, "the layout std140 gives it");
}  // namespace snow

class FrameBlock {
public:
    explicit FrameBlock(const SolidScene& solid);

    // tick: time steps made since the first flake. Returns what the shaders are told.
    const snow::Frame& update(const Window& window, const Settings& settings, unsigned tick);

private:
    void light(const snow::Weather& weather, const Settings& settings, float seconds);

    UniformBlock<snow::Frame> block_;
    snow::Frame frame_{};
    unsigned tick_before_ = 0;           // of the last update
    glm::vec3 lowest_{-1}, highest_{1};  // m, corners of a box around the scene
    glm::vec3 lamp_light_{};             // of the lamp that the scene has, when it is on
};
