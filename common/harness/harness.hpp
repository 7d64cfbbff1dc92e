// What watches a run from outside: it paces, measures, records and steers it, and draws the panel.
// None of it is part of any lesson.
#pragma once

#include <chrono>
#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <string>

#include "common/harness/controls.hpp"
#include "common/harness/options.hpp"
#include "common/harness/pacing.hpp"
#include "common/harness/panel.hpp"
#include "common/harness/terrain.hpp"
#include "common/harness/timer.hpp"

class Harness {
public:
    explicit Harness(CommandLine command);

    // With an OpenGL context current: says in one line what runs where, and starts the clocks.
    void begin_run();

    // Have the frames asked for been drawn?
    bool enough() const;

    // The moments of a frame: it begins; it is drawn, and can be saved; the panel is drawn over it;
    // it was shown; or it was never shown, because its window has gone.
    void begin_frame(Camera& camera);
    void record(glm::ivec2 size, bool last);
    void draw_panel(glm::ivec2 size);
    void frame_shown();
    void drop_frame() { timer.drop_frame(); }

    // In a frame of many time steps: is it time to see what the user has done? Waits for the GPU
    // then, or it might be as many steps behind.
    bool events_are_due();

    // After the last frame, or the last that there was time for: prints and writes what was
    // measured.
    void report(glm::ivec2 size);

    // Hands the panel what only it has a use for: keys let go, and the special ones.
    void let_panel_listen();

    // Input, which belongs to the panel first. False: it is not for the panel.
    bool panel_takes_key(unsigned char key, int x, int y);
    static constexpr int wheel_up = 3, wheel_down = 4;  // X11's buttons, which freeglut passes on
    bool panel_takes_button(int button, int state, int x, int y);
    void panel_sees_mouse(int x, int y);

    // A key that is neither for the panel nor for the window itself.
    void on_key(unsigned char key);

    // Does something without which the rest goes on: an error is told, and remembered.
    void attempt(const std::function<void()>& action);
    bool failed() const { return failed_; }

    CommandLine command;
    FrameTimer timer;
    Controls controls;
    Pacing pacing;
    double frame_seconds = 0;        // since the frame before
    std::optional<Terrain> terrain;  // of a scene in its own metres

private:
    using Clock = std::chrono::steady_clock;

    bool measuring() const { return command.benchmark || !command.csv.empty(); }
    void show_frame_time();
    void leave_off_what_is_costly();

    std::unique_ptr<Panel> panel_;
    bool show_panel_;
    bool failed_ = false;
    double tour_time_ = 0;   // s since it began
    bool software_ = false;  // no graphics card behind this OpenGL
    uint64_t drawn_ = 0;     // frames, warm-up included, and those that another stood for
    unsigned frames_in_last_ = 1;
    Clock::time_point last_frame_, last_swap_, last_title_, last_events_;
    uint64_t drawn_at_last_title_ = 0;
};
