// The window and its frame loop: `while (window.begin_frame()) { ... window.swap_buffers(); }` runs
// once a frame until the window is closed, Escape is pressed or the frames asked for are drawn.
#pragma once

#include <string>
#include <vector>

#include "common/camera.hpp"
#include "common/lesson.hpp"
#include "common/terrain.hpp"

// The class Harness (common/harness) derives from this one and fills in what is "= 0" here: it
// watches a run from outside, paces, measures, records and steers it, and draws the panel.
class Window {
public:
    // Opens it with an OpenGL context that is current. GLUT ends the program if that fails.
    Window(std::string name, glm::ivec2 size, const Camera& camera, bool debug);
    virtual ~Window();
    Window(const Window&) = delete;
    Window& operator=(const Window&) = delete;

    // Opens the next frame. False: the loop is over.
    bool begin_frame();

    // Shows what was drawn, under the panel, after a look at what the user has done meanwhile.
    void swap_buffers();

    // After the loop: did the user ask to begin anew, with another number of flakes perhaps, or
    // another variant? Then the clocks start again, and the next answer is no.
    virtual bool restarted() = 0;

    // A stage of the frame: its time is taken from here to the end of the block.
    class Stage {
    public:
        Stage(Window& window, const char* name) : window_(window) { window.begin_stage(name); }
        ~Stage() { window_.end_stage(); }
        Stage(const Stage&) = delete;
        Stage& operator=(const Stage&) = delete;

    private:
        Window& window_;
    };
    Stage stage(const char* name) { return {*this, name}; }

    // Is this frame to make another time step? As many as the clock has moved on, at most 8; one in
    // a run that is to be repeatable. All of it times --timelapse.
    virtual bool next_tick() = 0;
    virtual int ticks() const = 0;             // those it has made so far
    virtual double frame_seconds() const = 0;  // since the frame before

    virtual const Options& options() const = 0;
    glm::ivec2 size() const { return size_; }  // pixels, at least 1x1; stays during a frame
    glm::mat4 view() const { return camera_.view(); }
    glm::mat4 projection() const { return camera_.projection(size_); }
    glm::vec3 eye() const { return camera_.eye(); }

    // Tells how high the scene stands, if that is more than the world and the tour are made for.
    virtual void stand_on(const Terrain& terrain) = 0;

    // A line of the step's own for the panel, until it gives another.
    virtual void note(const std::string& line) = 0;

    // Writes the flakes as they are to the file of --dump, if there is one.
    virtual void dump(const std::vector<snow::Particle>& flakes) = 0;

protected:
    // The moments of a frame, in their order.
    virtual bool frame_begins() = 0;  // false: the loop is over
    virtual void begin_stage(const char* name) = 0;
    virtual void end_stage() = 0;
    virtual void save_frame() = 0;  // the last moment at which that can be done
    virtual void draw_panel() = 0;
    virtual void frame_is_shown() = 0;

    // What the user does. True: the button was pressed in the panel.
    virtual void press_key(unsigned char key, int x, int y) = 0;
    virtual bool press_button(int button, int state, int x, int y) = 0;
    virtual void move_mouse(int x, int y) = 0;

    void take_events();
    void close() { closing_ = true; }  // after this frame
    bool is_closing() const { return closing_; }

    Camera camera_;
    bool touring_ = false;  // the camera flies, until the user takes it

private:
    void on_close();
    void on_button(int button, int state, int x, int y);
    void on_motion(int x, int y);

    glm::ivec2 size_, next_size_;
    glm::ivec2 mouse_{};
    bool dragging_ = false;
    bool closing_ = false, gone_ = false;  // the window is to be closed; it is closed
    bool drawn_ = false;                   // a frame waits to be shown
};
