// Tells all shaders of the winter where the picture is taken from, once a frame.
#pragma once

#include "common/snow.hpp"
#include "common/uniform_block.hpp"
#include "common/window.hpp"

namespace snow {
#include "step06_accumulation/winter/camera/camera.glsl"
static_assert(sizeof(CameraView) == 224, "the layout std140 gives it");
}  // namespace snow

class CameraBlock {
public:
    // tick: time steps made since the first flake.
    void update(const Window& window, unsigned tick);

private:
    UniformBlock<snow::CameraView> block_;
    snow::CameraView camera_{};
};
