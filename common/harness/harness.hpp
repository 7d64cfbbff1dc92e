// The window with all that watches a run from outside: it paces, measures, records and steers it.
// None of it belongs to any lesson.
#pragma once

#include <chrono>
#include <cstdint>
#include <functional>
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
    ~Harness() override;

    bool begin_frame() override;
    void swap_buffers() override;
    bool restarted() override;
    bool next_tick() override;
    const CommandLine& options() const override { return command_; }
    void stand_on(const Terrain& terrain) override;
    void note(const std::string& line) override { controls_.note = line; }
    void dump(const std::vector<snow::Particle>& flakes) override;

    // Has an output not been written? A line on stderr has said so.
    bool failed() const { return failed_; }

private:
    using Clock = std::chrono::steady_clock;

    void begin_stage(const char* name) override { timer_.begin_stage(name); }
    void end_stage() override { timer_.end_stage(); }

    bool measuring() const { return command_.benchmark || !command_.csv.empty(); }
    bool enough() const;
    void begin_run();
    void pace();
    void move_camera();
    void save_frame();
    void show_frame_time();
    void report();
    void attempt(const std::function<void()>& action, bool matters = true);

    void on_close();
    void press(unsigned char key);  // or its button in the panel
    void on_special_key(int key, bool down, int x, int y);
    void on_button(int button, int state, int x, int y);
    void on_motion(int x, int y);

    CommandLine command_;
    Controls controls_;
    FrameTimer timer_;
    std::optional<Panel> panel_;
    bool show_panel_;
    bool failed_ = false;
    bool closing_ = false, gone_ = false;  // the window is to be closed; it is closed
    bool drawn_now_ = false;               // a frame waits to be shown
    glm::ivec2 next_size_, mouse_{};
    bool dragging_ = false, panning_ = false;
    glm::vec3 flying_{0};  // to the right, up and ahead: -1, 0 or 1, as keys are held down

    bool touring_;                    // the camera flies, until the user takes it
    double tour_seconds_ = 0;         // since it began
    std::optional<Terrain> terrain_;  // of a scene in its own metres
    float raise_world_by_ = 0;        // m, in the next frame

    uint64_t drawn_ = 0;       // frames, warm-up included, and those that another stood for
    unsigned stands_for_ = 1;  // frames, the one that is open or the last
    int due_ = 0;              // time steps that it is to make
    double owed_seconds_ = 0;  // of physics that the clock is ahead
    Clock::time_point last_frame_, last_swap_, last_events_, last_title_;
    uint64_t drawn_at_last_title_ = 0;
};
