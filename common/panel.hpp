// The panel over the picture: what the frame costs, and sliders for what it shows.
#pragma once

#include <string>

#include "common/options.hpp"
#include "common/timer.hpp"

class Panel {
public:
    // What a user may ask of the frame loop.
    struct Controls {
        bool paused = false;
        bool single_step = false;  // one step of physics, then pause again
        bool restart = false;      // begin anew, with all buffers as large as they then need to be
        bool weather_changed = false;  // since the frame before
        std::string note;              // the step's own line
    };

    Panel();
    ~Panel();
    Panel(const Panel&) = delete;
    Panel& operator=(const Panel&) = delete;

    // Draws it over a frame of `size` pixels; the sliders change `options` and `controls`.
    void draw(glm::ivec2 size, Options& options, Controls& controls,
              const std::deque<FrameTime>& frames, const std::string& renderer);

    // Does the mouse, or the keyboard, belong to the panel now?
    bool wants_mouse() const;
    bool wants_keys() const;
};
