// The panel over the picture: what the frame costs, and sliders for what it shows.
#pragma once

#include <deque>
#include <string>

#include "common/harness/options.hpp"
#include "common/harness/timing.hpp"

// What a user may ask of the frame loop, by key or in the panel.
struct Controls {
    bool paused = false;
    bool single_step = false;   // one time step, then pause again
    bool restart = false;       // begin anew, with all buffers as large as they then need to be
    bool save_picture = false;  // of the frame that is next
    unsigned char key = 0;      // whose button was pressed: not all keyboards have Latin letters
    std::string note;           // the step's own line, for the panel
};

constexpr unsigned char escape_key = 27;

// How far the wheel was turned: X11 has buttons for that, which freeglut passes on.
inline int wheel_notches(int button)
{
    return button == 3 ? 1 : button == 4 ? -1 : 0;
}

class Panel {
public:
    Panel();
    ~Panel();
    Panel(const Panel&) = delete;
    Panel& operator=(const Panel&) = delete;

    // Draws it over a frame of `size` pixels; the sliders change `command` and `controls`.
    void draw(glm::ivec2 size, CommandLine& command, Controls& controls,
              const std::deque<FrameTime>& frames, const std::string& renderer);

    // What the user does. True: it was for the panel.
    bool press_key(unsigned char key, int x, int y);
    bool press_special_key(int key, bool down, int x, int y);
    bool press_button(int button, int state, int x, int y);
    void move_mouse(int x, int y);

    // Forgets what is being dragged: the panel is hidden now.
    void let_go();
};

// What it consists of: between ImGui::NewFrame and ImGui::Render, no matter what those are shown
// on.
void lay_out_panel(CommandLine& command, Controls& controls, const std::deque<FrameTime>& frames,
                   const std::string& renderer);
