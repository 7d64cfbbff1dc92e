// The panel over the picture: what the frame costs, and sliders for what it shows.
#pragma once

#include <deque>
#include <string>

#include "common/harness/controls.hpp"
#include "common/harness/options.hpp"
#include "common/harness/timer.hpp"

class Panel {
public:
    Panel();
    ~Panel();
    Panel(const Panel&) = delete;
    Panel& operator=(const Panel&) = delete;

    // Draws it over a frame of `size` pixels; the sliders change `command` and `controls`.
    void draw(glm::ivec2 size, CommandLine& command, Controls& controls,
              const std::deque<FrameTime>& frames, const std::string& renderer);

    // Does the mouse, or the keyboard, belong to the panel now?
    bool wants_mouse() const;
    bool wants_keys() const;

    // Is Ctrl held down while the mouse is used?
    void set_control_key(bool down);

    // Forgets what is being dragged: the panel is hidden now.
    void let_go();
};

// What it consists of: between ImGui::NewFrame and ImGui::Render, no matter what those are shown
// on.
void lay_out_panel(CommandLine& command, Controls& controls, const std::deque<FrameTime>& frames,
                   const std::string& renderer);
