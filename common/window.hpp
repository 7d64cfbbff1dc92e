// The window and its frame loop: `while (window.begin_frame()) { ... }` runs once a frame until the
// window is closed, Escape is pressed or the frames asked for are drawn.
#pragma once

#include <chrono>
#include <exception>
#include <glm/glm.hpp>
#include <string>

#include "common/camera.hpp"
#include "common/options.hpp"

class Window {
public:
    // Opens it with an OpenGL context and reports both in one line. Throws std::runtime_error if
    // there is no display, or OpenGL lacks the version or an extension that the step needs.
    explicit Window(const Options& options);
    ~Window();
    Window(const Window&) = delete;
    Window& operator=(const Window&) = delete;

    // Shows the frame before, handles events, and clears for the next. False: the loop is over.
    bool begin_frame();

    // Physics steps that this frame is to make: one in a reproducible run; else as many time steps
    // as the clock has moved on, at most 8 (a longer hitch slows the snow down, it never skips).
    int steps() const { return steps_; }

    glm::ivec2 size() const { return size_; }  // pixels, at least 1x1
    glm::mat4 view() const { return camera_.view(); }
    glm::mat4 projection() const { return camera_.projection(size_); }
    glm::vec3 eye() const { return camera_.eye(); }

private:
    void check_gl() const;
    void announce() const;
    void finish_frame();
    int steps_since_last_frame();
    void show_frame_time();
    static void on_key(unsigned char key, int x, int y);
    static void on_button(int button, int state, int x, int y);
    static void on_drag(int x, int y);
    static void on_reshape(int width, int height);

    using Clock = std::chrono::steady_clock;
    Options options_;
    Camera camera_;
    glm::ivec2 size_;
    glm::ivec2 mouse_{};
    int window_ = 0;
    bool closing_ = false;
    unsigned drawn_ = 0;  // frames, warm-up included
    int steps_ = 0;
    double owed_ = 0;  // s of physics the clock is ahead
    Clock::time_point last_frame_, last_title_;
    unsigned drawn_at_last_title_ = 0;
};

// Says on stderr, in one line, why the program cannot run. Returns its exit status, 1.
int report_failure(const std::exception& failure);
