// The window and its frame loop: `while (window.begin_frame()) { ... window.swap_buffers(); }` runs
// once a frame until the window is closed, Escape is pressed or the frames asked for are drawn.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "common/camera.hpp"
#include "common/lesson.hpp"

class Harness;     // what watches a run from outside: common/harness/harness.hpp
class FrameTimer;  // common/harness/timer.hpp
class Terrain;     // common/harness/terrain.hpp
struct CommandLine;

// A stage of the frame: from its declaration to the end of its block the time is taken.
class StageTimer {
public:
    StageTimer(FrameTimer* timer, const char* name);  // null: nobody wants to know
    ~StageTimer();
    StageTimer(const StageTimer&) = delete;
    StageTimer& operator=(const StageTimer&) = delete;

private:
    FrameTimer* timer_;
};

class Window {
public:
    // Opens it with an OpenGL context and reports both in one line. Throws std::runtime_error if
    // there is no display, or OpenGL lacks the version or an extension that the step needs.
    explicit Window(CommandLine command);
    ~Window();
    Window(const Window&) = delete;
    Window& operator=(const Window&) = delete;

    // Opens the next frame. False: the loop is over.
    bool begin_frame();

    // After the loop: did the user ask to begin anew, with another number of flakes perhaps, or
    // another variant? Then the clocks start again, and the next answer is no.
    bool restarted();

    // Shows what was drawn, under the panel, after a look at what the user has done meanwhile.
    void swap_buffers();

    // Times the block it is declared in as a stage of this frame.
    StageTimer stage(const char* name);

    // Is this frame to make another time step? As many as the clock has moved on, at most 8; one in
    // a run that is to be repeatable. All of it times --timelapse.
    bool next_tick();
    int ticks() const;             // those it has made so far
    double frame_seconds() const;  // since the frame before

    const Options& options() const { return options_; }
    glm::ivec2 size() const { return size_; }  // pixels, at least 1x1; stays during a frame
    glm::mat4 view() const { return camera_.view(); }
    glm::mat4 projection() const { return camera_.projection(size_); }
    glm::vec3 eye() const { return camera_.eye(); }

    // Tells how high the scene stands, if that is more than the world and the tour are made for.
    void stand_on(const Terrain& terrain);

    // A line of the step's own for the panel, until it gives another.
    void note(const std::string& line);

    // Writes the flakes as they are to the file of --dump, if there is one.
    void dump(const std::vector<snow::Particle>& flakes) const;

private:
    friend int run_lesson(int argc, char** argv, const Lesson& lesson);
    void take_events();
    void on_close();
    static void on_key(unsigned char key, int x, int y);
    static void on_button(int button, int state, int x, int y);
    static void on_motion(int x, int y);
    static void on_reshape(int width, int height);

    std::unique_ptr<Harness> harness_;
    const Options& options_;
    Camera camera_;
    glm::ivec2 size_, next_size_;
    glm::ivec2 mouse_{};
    bool dragging_ = false;
    bool closing_ = false, gone_ = false;  // the window is to be closed; it is closed
    bool drawn_ = false;                   // a frame waits to be shown
};
