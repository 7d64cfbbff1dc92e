// Holds a frame rate by moving and drawing fewer flakes, or more, when a frame takes too long, or
// is done early.
#pragma once

#include <string>

#include "common/program.hpp"

// Decides what share of the flakes lives: fewer when frames are too long, more when they are too
// short. In between lies a band, of a tenth either way, in which nothing changes.
class FlakeBudget {
public:
    // Takes in a frame: how many s it took and how many steps the snow made in it. fps: the rate to
    // hold, 0 for none. maximum: the largest share allowed, 0.01 to 1.
    void frame(double seconds, int ticks, float fps, float maximum);

    float share() const;         // 0.01 to 1
    std::string report() const;  // for the user

private:
    float share_ = 1, maximum_ = 1;
    float told_ = 1;                    // the share that the user was told last
    double seconds_ = 0, longest_ = 0;  // of the frames since the last decision
    int frames_ = 0, ticks_ = 0;
};

// The flakes that live: the first of each emitter's half of the pool. The others wait, as they are,
// for better times.
struct LiveFlakes {
    // share: of all flakes, 0 to 1.
    LiveFlakes(unsigned particles, float share);

    // How many flakes each one that lives stands for.
    float weight() const;

    // Draws them as points, with the vertex array that is bound.
    void draw() const;

    // Draws one in eight of them, eight times.
    void draw_around() const;

    // Tells a program in use which flakes live (flakes/live.glsl).
    void set(Program& program) const;

    unsigned particles;  // all
    GLint first[2];      // flake that lives, of each half
    GLsizei count[2];    // of those that live
};
