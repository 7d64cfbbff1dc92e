// What watches a run from outside: it paces, measures, records and steers it, and draws the panel.
// None of it is part of any lesson.
#pragma once

#include <chrono>
#include <memory>
#include <string>

#include "common/harness/controls.hpp"
#include "common/harness/options.hpp"
#include "common/harness/pacing.hpp"
#include "common/harness/panel.hpp"
#include "common/harness/timer.hpp"

class Harness {
public:
    explicit Harness(CommandLine command);

    // With an OpenGL context current: says in one line what runs where, and starts the clocks.
    void begin_run();

    // Have the frames asked for been drawn?
    bool enough() const;

    // The four moments of a frame: it begins; it is drawn, and about to be shown; it was shown; or
    // it was never shown, because its window has gone.
    void begin_frame(Camera& camera, int& ticks, double& seconds);
    void finish_frame(glm::ivec2 size, bool last);
    void frame_shown();
    void drop_frame() { timer.drop_frame(); }

    // After the last frame, or the last that there was time for: prints and writes what was
    // measured.
    void report(glm::ivec2 size);

    // Input, which belongs to the panel first. False: it is not for the panel.
    bool panel_takes_key(unsigned char key, int x, int y);
    bool panel_takes_button(int button, int state, int x, int y);
    void panel_sees_mouse(int x, int y);

    // A key that is neither for the panel nor for the window itself.
    void on_key(unsigned char key);

    CommandLine command;
    FrameTimer timer;
    Controls controls;

private:
    using Clock = std::chrono::steady_clock;

    bool measuring() const { return command.benchmark || !command.csv.empty(); }
    void show_frame_time();

    Pacing pacing_;
    std::unique_ptr<Panel> panel_;
    bool show_panel_;
    double tour_time_ = 0;   // s since it began
    bool software_ = false;  // no graphics card behind this OpenGL
    unsigned drawn_ = 0;     // frames, warm-up included
    Clock::time_point last_frame_, last_swap_, last_title_;
    unsigned drawn_at_last_title_ = 0;
};
