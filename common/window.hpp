// The window and its frame loop: `while (window.begin_frame()) { ... window.swap_buffers(); }` runs
// once a frame until the window is closed, Escape is pressed or the frames asked for are drawn.
#pragma once

#include <string>
#include <vector>

#include "common/camera.hpp"
#include "common/lesson.hpp"
#include "common/terrain.hpp"

// What a lesson sees of it; the class Harness (common/harness) does it all.
class Window {
public:
    virtual ~Window() = default;

    // Opens the next frame. False: the loop is over.
    virtual bool begin_frame() = 0;

    // Shows what was drawn, under the panel, after a look at what the user has done meanwhile.
    virtual void swap_buffers() = 0;

    // After the loop: did the user ask to begin anew, with another number of flakes perhaps, or
    // another variant? Then the clocks start again, and the next answer is no.
    virtual bool restarted() = 0;

    // A stage of the frame: its time is taken from here to the end of the block.
    struct Stage {
        Window& window;
        ~Stage() { window.end_stage(); }
    };
    Stage stage(const char* name)
    {
        begin_stage(name);
        return {*this};
    }

    // Is this frame to make another time step? As many as the clock has moved on, at most 8; one in
    // a run that is to be repeatable. All of it times --timelapse.
    virtual bool next_tick() = 0;
    int ticks() const { return ticks_; }                     // those it has made so far
    double frame_seconds() const { return frame_seconds_; }  // since the frame before

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
    virtual void begin_stage(const char* name) = 0;
    virtual void end_stage() = 0;

    Camera camera_;
    glm::ivec2 size_{};
    int ticks_ = 0;
    double frame_seconds_ = 0;
};
