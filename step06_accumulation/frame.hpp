// Tells all shaders of step 6 where the picture is taken from, once a frame.
#pragma once

#include <GL/glew.h>

#include <algorithm>

#include "common/gl_object.hpp"
#include "common/window.hpp"

namespace snow {
#include "step06_accumulation/frame.glsl"
static_assert(sizeof(Frame) == 224, "the layout std140 gives it");
}  // namespace snow

class FrameBlock {
public:
    FrameBlock() : buffer_(make_buffer())
    {
        glBindBuffer(GL_UNIFORM_BUFFER, buffer_);
        glBufferData(GL_UNIFORM_BUFFER, sizeof frame_, nullptr, GL_DYNAMIC_DRAW);
        glBindBufferBase(GL_UNIFORM_BUFFER, 1, buffer_);
    }

    // step: physics steps made since the first flake.
    void update(const Window& window, unsigned step)
    {
        const snow::Weather& weather = window.options().weather;
        const bool first = frame_.window_size.x == 0;
        frame_.view_before = first ? window.view() : frame_.view;
        frame_.view = window.view();
        frame_.projection = window.projection();
        frame_.eye = window.eye();
        frame_.shutter =
            float(window.steps()) * weather.time_step / float(window.options().timelapse);
        frame_.window_size = window.size();
        // The first flakes fall and lie for a while before they are part of the cover.
        const snow::Emitter& cloud = weather.emitters[0];
        const float late = cloud.centre.y / cloud.terminal_speed + weather.melt_time;  // s
        frame_.field_depth =
            weather.snowfall / 60.0f * std::max(float(step) * weather.time_step - late, 0.0f);
        glBindBuffer(GL_UNIFORM_BUFFER, buffer_);
        glBufferSubData(GL_UNIFORM_BUFFER, 0, sizeof frame_, &frame_);
    }

private:
    GlObject buffer_;
    snow::Frame frame_{};
};
