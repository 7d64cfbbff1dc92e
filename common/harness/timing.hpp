// How long frames take, and which of their stages takes how much of that, on the CPU and on the
// GPU: measured frame by frame, and summed up for the eye and for programs.
#pragma once

#include <GL/glew.h>

#include <chrono>
#include <deque>
#include <optional>
#include <string>
#include <vector>

#include "common/harness/options.hpp"

struct StageTime {
    std::string name;
    double cpu_ms = 0;             // from the first call of the stage to the return of its last
    std::optional<double> gpu_ms;  // what the GPU took for it; empty: not known (yet)
    GLuint queries[2] = {};        // timestamps at its begin and its end, until they have arrived
};

struct FrameTime {
    double frame_ms = 0;        // from one swap of buffers to the next
    bool synchronised = false;  // gpu_ms is the time until glFinish returned, not a query's
    std::vector<StageTime> stages;
};

class FrameTimer {
public:
    // Opens a frame. Synchronised: the pipeline is emptied around every stage, which makes stages
    // comparable where a driver's queries are not, and frames slower.
    void begin_frame(bool synchronised);
    void end_frame(double frame_ms, size_t keep);  // and forgets all but the last of them

    // Times a stage of the open frame; does nothing if none is open. Stages do not nest.
    void begin_stage(const char* name);
    void end_stage();

    // Forgets a frame that was never shown, and waits for the queries still under way. For the end,
    // never in a frame.
    void finish();

    const std::deque<FrameTime>& frames() const { return frames_; }

private:
    void collect(bool wait);

    std::deque<FrameTime> frames_;
    size_t collected_ = 0;  // of them, from the first on: their timestamps have arrived
    bool open_ = false;
    std::chrono::steady_clock::time_point stage_begin_;
};

// The value below which `fraction` (0 to 1) of the values lie; 0 if there are none.
double quantile(std::vector<double> values, double fraction);

// The table of --csv: one row a frame.
std::string csv_of(const std::deque<FrameTime>& frames, const CommandLine& command, glm::ivec2 size,
                   const std::string& renderer);

// Prints median, p95 and worst percent of the frame times, and the median of each stage.
void print_summary(const std::deque<FrameTime>& frames);
