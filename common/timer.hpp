// How long a frame takes, and which of its stages takes how much of that, on the CPU and on the
// GPU.
#pragma once

#include <GL/glew.h>

#include <chrono>
#include <cstddef>
#include <deque>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "common/options.hpp"

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

class FrameTimer {
public:
    // Lasts as long as the stage it times.
    class Stage {
    public:
        Stage(FrameTimer* timer, const char* name);
        ~Stage();
        Stage(const Stage&) = delete;
        Stage& operator=(const Stage&) = delete;

    private:
        FrameTimer* timer_;  // null: nobody wants to know
        std::chrono::steady_clock::time_point begin_;
    };

    // Opens a frame. Synchronised: the pipeline is emptied around every stage, which makes stages
    // comparable where a driver's queries are not, and frames slower.
    void begin_frame(bool synchronised);
    void end_frame(double frame_ms);
    void drop_frame();  // it never came to be shown

    // Times the block it is declared in. Stages do not nest. Costs a few microseconds, or nothing
    // if no frame is open. Throws std::logic_error if another stage is still running.
    Stage stage(const char* name) { return Stage(open_ ? this : nullptr, name); }

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
    std::deque<Pending> pending_;
    std::vector<GLuint> free_queries_;
};

// The value below which `part` (0 to 1) of the values lie; 0 if there are none.
double quantile(std::vector<double> values, double part);

// Writes one row a frame. Throws std::runtime_error.
void write_csv(const std::filesystem::path& path, const Options& options, glm::ivec2 size,
               const std::string& renderer, const std::deque<FrameTime>& frames);

// Prints median, p95 and worst percent of the frame times, and the median of each stage.
void print_summary(const std::deque<FrameTime>& frames);
