// Holds a frame rate by moving and drawing fewer flakes, or more, when a frame takes too long, or
// is done early.
#pragma once

#include <string>
#include <vector>

#include "common/weather.hpp"

// Decides what share of the flakes lives: fewer at once when frames are too long, more, and with
// care, when they are too short. In between lies a band, of a tenth either way, in which nothing
// changes. Growth never leads across the band, not even where frames grow with the fifth power of
// the share, as they do when long frames have more steps to make. Where it was too much all the
// same, it waits twice as long before it tries again, so the share does not swing.
class FlakeBudget {
public:
    static std::vector<snow::Parameter> parameters();
    inline static float hold_fps = 0;  // frames a second to hold; 0: none
    inline static float live = 1;      // the largest share of the flakes that moves, 0.01 to 1

    // Takes in a frame: how many s it took and how many steps the snow made in it. fps: the rate to
    // hold, 0 for none. maximum: the largest share allowed, 0.01 to 1.
    void frame(double seconds, int ticks, float fps, float maximum);

    float share() const;         // 0.01 to 1
    std::string report() const;  // for the user

private:
    void decide(float slowness);  // of a frame: 1 if it takes as long as it may

    float share_ = 1, maximum_ = 1;
    bool growing_ = false;
    int patience_ = 1, waited_ = 0;     // decisions between a cut and the growth after it
    float told_ = 1;                    // the share that the user was told last
    double seconds_ = 0, longest_ = 0;  // of the frames since the last decision
    int frames_ = 0, ticks_ = 0;
};
