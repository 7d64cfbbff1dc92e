// How many time steps a frame makes: as many as the clock has moved on, or always the same.
#pragma once

#include "common/harness/controls.hpp"
#include "common/harness/options.hpp"

class Pacing {
public:
    // The steps of a frame that comes `seconds` after the one before. A run that is to be
    // repeatable makes one; else the clock says how many, at most 8 (a longer hitch slows the snow
    // down, it never skips). All of it times --timelapse.
    int ticks(const CommandLine& command, double seconds, Controls& controls);

private:
    double owed_ = 0;  // s of physics that the clock is ahead
};
