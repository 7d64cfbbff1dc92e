// How long a frame takes, and which of its stages takes how much of that, on the CPU and on the
// GPU.
#pragma once

#include <GL/glew.h>

#include <chrono>
#include <cstddef>
#include <deque>
#include <optional>
#include <string>
#include <vector>

struct StageTime {
    std::string name;
    double cpu_ms = 0;             // from the first call of the stage to the return of its last
    std::optional<double> gpu_ms;  // what the GPU took for it; empty: not known (yet)
};

struct FrameTime {
    double frame_ms = 0;        // from one swap of buffers to the next
    bool synchronised = false;  // gpu_ms is the time until glFinish returned, not a query's
    std::vector<StageTime> stages;
};

// From one timestamp to another, ns. Some cards count with fewer than 64 bits, and begin anew after
// a minute.
GLuint64 nanoseconds_between(GLuint64 begin, GLuint64 end, GLint bits);

class FrameTimer {
public:
    // Opens a frame. Synchronised: the pipeline is emptied around every stage, which makes stages
    // comparable where a driver's queries are not, and frames slower.
    void begin_frame(bool synchronised);
    void end_frame(double frame_ms);
    void drop_frame();  // it never came to be shown

    bool open() const { return open_; }

    // Where StageTimer, which common/window.hpp declares, begins and ends a stage of the open
    // frame. Stages do not nest: begin_stage throws std::logic_error if another is still running.
    void begin_stage(const char* name);
    void end_stage();

    // Forgets all but the last `count` frames.
    void keep(size_t count);
    void clear();

    // Waits for the queries still under way. For the end, never in a frame.
    void finish();

    const std::deque<FrameTime>& frames() const { return frames_; }

    // What timing one stage costs, ms, measured by timing a thousand empty ones.
    static double cost_of_a_stage();

private:
    struct Pending {  // a stage whose two timestamps have not arrived yet
        size_t frame, stage;
        GLuint begin, end;
    };
    void collect(bool wait);
    GLuint take_query();

    std::deque<FrameTime> frames_;
    size_t forgotten_ = 0;  // frames before the first of frames_
    bool open_ = false, running_ = false;
    std::chrono::steady_clock::time_point stage_begin_;  // of the one that is running
    std::deque<Pending> pending_;
    std::vector<GLuint> free_queries_;
};
