// How many time steps a frame makes: as many as the clock has moved on, or always the same.
#pragma once

#include <chrono>
#include <cstdint>

#include "common/harness/controls.hpp"
#include "common/harness/options.hpp"

// How many frames the next one stands for, after so many. A warm-up need not be seen: where a run
// is to be repeatable, a frame makes the steps of sixty, as long as at least sixty are left, which
// are drawn one by one, as those that count will be.
unsigned frames_in_one(const CommandLine& command, uint64_t drawn);

class Pacing {
public:
    // Begins a frame that comes `seconds` after the one before and stands for so many `frames`. A
    // run that is to be repeatable makes one step for each; else the clock says how many, at most 8
    // (a longer hitch slows the snow down, it never skips). All of it times --timelapse. Returns
    // how many are due.
    int begin_frame(const CommandLine& command, double seconds, unsigned frames,
                    Controls& controls);

    // Is another step to be made in this frame? Where the clock says how many, they end after a
    // twentieth of a second, so that the program answers its user, however slow a step is.
    bool next_tick();

    int ticks() const { return made_; }  // in this frame, so far

private:
    double owed_ = 0;  // s of physics that the clock is ahead
    int due_ = 0, made_ = 0;
    bool by_the_clock_ = false;
    std::chrono::steady_clock::time_point begin_;
};
