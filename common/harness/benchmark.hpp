// What the times of many frames come to: a summary for the eye, a table for programs.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "common/harness/options.hpp"
#include "common/harness/timer.hpp"

// When a benchmark, or --csv, wants a frame's stages timed.
enum class Timing {
    off,
    queries,      // by timestamps of the GPU
    synchronised  // between calls of glFinish, in frames of their own
};

// How to time frame `drawn`, counted from 0, warm-up included. software: the renderer's timestamps
// may read 0.
Timing timing_of_frame(const CommandLine& command, uint64_t drawn, bool software);

// The value below which `fraction` (0 to 1) of the values lie; 0 if there are none.
double quantile(std::vector<double> values, double fraction);

// Writes one row a frame. Throws std::runtime_error.
void write_csv(const std::filesystem::path& path, const CommandLine& command, glm::ivec2 size,
               const std::string& renderer, const std::deque<FrameTime>& frames);

// Prints median, p95 and worst percent of the frame times, and the median of each stage.
void print_summary(const std::deque<FrameTime>& frames);
