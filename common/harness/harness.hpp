// The window with all that watches a run from outside: it paces, measures, records and steers it.
// None of it belongs to any lesson.
#pragma once

#include <chrono>
#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <string>

#include "common/harness/options.hpp"
#include "common/harness/panel.hpp"
#include "common/harness/timing.hpp"
#include "common/window.hpp"

class Harness : public Window {
public:
    // Opens the window and says in one line what runs where. Throws std::runtime_error if this
    // OpenGL is not enough for the lesson.
    explicit Harness(CommandLine line);

    bool restarted() override;
    bool next_tick() override;
    int ticks() const override { return ticks_; }
    double frame_seconds() const override { return frame_seconds_; }
    const CommandLine& options() const override { return command_; }
    void stand_on(const Terrain& terrain) override;
    void note(const std::string& line) override { controls_.note = line; }
    void dump(const std::vector<snow::Particle>& flakes) override;

    // Has an output not been written? A line on stderr has said so.
    bool failed() const { return failed_; }

private:
    using Clock = std::chrono::steady_clock;

    bool frame_begins() override;
    void begin_stage(const char* name) override { timer_.begin_stage(name); }
    void end_stage() override { timer_.end_stage(); }
    void save_frame() override;
    void draw_panel() override;
    void frame_is_shown() override;
    void press_key(unsigned char key, int x, int y) override;
    bool press_button(int button, int state, int x, int y) override;
    void move_mouse(int x, int y) override;

    bool measuring() const { return command_.benchmark || !command_.csv.empty(); }
    bool enough() const;
    void begin_run();
    void leave_off_what_is_costly();
    void pace();
    void move_camera();
    void show_frame_time();
    void report();
    void attempt(const std::function<void()>& action, bool matters = true);

    CommandLine command_;
    Controls controls_;
    FrameTimer timer_;
    std::unique_ptr<Panel> panel_;
    bool show_panel_;
    const char* vsync_ = "";
    bool failed_ = false;
    std::optional<Terrain> terrain_;  // of a scene in its own metres
    float raise_world_by_ = 0;        // m, in the next frame
    double tour_seconds_ = 0;         // since it began

    uint64_t drawn_ = 0;        // frames, warm-up included, and those that another stood for
    unsigned stands_for_ = 1;   // frames, the one that is open or the last
    int due_ = 0, ticks_ = 0;   // time steps that it is to make, and has made
    double owed_seconds_ = 0;   // of physics that the clock is ahead
    double frame_seconds_ = 0;  // since the frame before
    Clock::time_point last_frame_, last_swap_, last_events_, last_title_;
    uint64_t drawn_at_last_title_ = 0;
};
