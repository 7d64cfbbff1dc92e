// The window and its frame loop: `while (window.begin_frame()) { ... }` runs once a frame until the
// window is closed, Escape is pressed or the frames asked for are drawn.
#pragma once

#include <chrono>
#include <functional>
#include <glm/glm.hpp>
#include <memory>
#include <string>

#include "common/camera.hpp"
#include "common/options.hpp"
#include "common/panel.hpp"
#include "common/timer.hpp"

class Window {
public:
    // Opens it with an OpenGL context and reports both in one line. Throws std::runtime_error if
    // there is no display, or OpenGL lacks the version or an extension that the step needs.
    explicit Window(Options options);
    ~Window();
    Window(const Window&) = delete;
    Window& operator=(const Window&) = delete;

    // Handles events, shows the frame before, and clears for the next. False: the loop is over.
    bool begin_frame();

    // After the loop: has the user asked to begin anew? The options may then have changed.
    bool again();

    // Times the block it is declared in as a stage of this frame.
    FrameTimer::Stage stage(const char* name) { return timer_.stage(name); }

    // Physics steps that this frame is to make: one in a reproducible run; else as many time steps
    // as the clock has moved on, at most 8 (a longer hitch slows the snow down, it never skips).
    // All of it times --timelapse.
    int steps() const { return steps_; }

    double frame_seconds() const { return frame_seconds_; }  // since the frame before

    // A line of the step's own for the panel, until it gives another.
    void note(const std::string& line) { controls_.note = line; }

    // Has a slider moved since the frame before?
    bool weather_changed() const { return weather_changed_; }

    const Options& options() const { return options_; }
    glm::ivec2 size() const { return size_; }  // pixels, at least 1x1
    glm::mat4 view() const { return camera_.view(); }
    glm::mat4 projection() const { return camera_.projection(size_); }
    glm::vec3 eye() const { return camera_.eye(); }

private:
    using Clock = std::chrono::steady_clock;

    void check_gl() const;
    void announce();
    void finish_frame(bool last);
    void report();
    bool measuring() const { return options_.benchmark || !options_.csv.empty(); }
    int steps_of_this_frame();
    void fly();
    void show_frame_time();
    static void on_key(unsigned char key, int x, int y);
    static void on_button(int button, int state, int x, int y);
    static void on_motion(int x, int y);
    static void on_reshape(int width, int height);

    Options options_;
    Camera camera_;
    FrameTimer timer_;
    std::unique_ptr<Panel> panel_;
    Panel::Controls controls_;
    bool show_panel_;
    glm::ivec2 size_;
    glm::ivec2 mouse_{};
    bool dragging_ = false;
    bool closing_ = false, save_screenshot_ = false, weather_changed_ = false;
    bool touring_;           // on the flight that the key T and --tour begin
    double tour_time_ = 0;   // s since it began
    bool software_ = false;  // no graphics card behind this OpenGL
    bool frame_open_ = false, window_gone_ = false;
    unsigned drawn_ = 0;  // frames, warm-up included
    int steps_ = 0;
    double frame_seconds_ = 0;
    double owed_ = 0;  // s of physics the clock is ahead
    Clock::time_point last_frame_, last_swap_, last_title_;
    unsigned drawn_at_last_title_ = 0;
};

// The whole of a step's program: takes the command line, opens the window and calls `program`.
// Returns the exit status: 0 done, 1 cannot run, after one line on stderr that says why. (A wrong
// command line ends the program with 2.)
int run_program(int argc, char** argv, const Step& step,
                const std::function<void(Window&)>& program);

// A program that calls `run`, from the first flake to the last, until the user has had enough.
inline int run_step(int argc, char** argv, const Step& step, void (*run)(Window&))
{
    return run_program(argc, argv, step, [run](Window& window) {
        do run(window);
        while (window.again());
    });
}

// The same, for a step with a World: what it makes of the options once, and every run shares.
template <typename World>
int run_step(int argc, char** argv, const Step& step, void (*run)(Window&, const World&))
{
    return run_program(argc, argv, step, [run](Window& window) {
        const World world(window.options());
        do run(window, world);
        while (window.again());
    });
}
