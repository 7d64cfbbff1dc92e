// Holds a frame rate by moving and drawing fewer flakes, or more, when a frame takes too long, or
// is done early.
#pragma once

#include <GL/glew.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <iostream>
#include <string>

#include "common/snow.hpp"

// Decides what share of the flakes lives: fewer at once when frames are too long, more, and with
// care, when they are too short. In between lies a band, of a tenth either way, in which nothing
// changes. Growth never leads across the band, not even where frames grow with the fifth power of
// the share, as they do when long frames have more steps to make. Where it was too much all the
// same, it waits twice as long before it tries again, so the share does not swing.
class FrameRate {
public:
    // Takes in a frame: how many s it took and how many steps the snow made in it. fps: the rate to
    // hold, 0 for none. most: the largest share allowed, 0.01 to 1.
    void frame(double seconds, int steps, float fps, float most)
    {
        if (fps <= 0) *this = {};
        most_ = most;
        longest_ = std::max(longest_, seconds);
        seconds_ += seconds;
        steps_ += steps;
        if (++frames_ < 5 || seconds_ < 0.4 || fps <= 0) return;
        // Without the longest, which may have been a hitch.
        const float slowness = float((seconds_ - longest_) / (frames_ - 1)) * fps;
        const bool paused = steps_ == 0;
        seconds_ = longest_ = 0;
        frames_ = steps_ = 0;
        if (!paused) decide(slowness);
        share_ = std::clamp(share_, 0.01f, 1.0f);
        if (share_ > 0.75f * told_ && told_ > 0.75f * share_) return;
        told_ = share_;
        std::cout << "holding " << fps << " fps: " << report() << std::endl;
    }

    float share() const { return std::min(share_, most_); }  // 0.01 to 1

    std::string report() const  // for the user
    {
        return std::to_string(int(std::lround(100 * share()))) + " % of the flakes live";
    }

private:
    void decide(float slowness)  // of a frame: 1 if it takes as long as it may
    {
        if (slowness > 1.1f) {
            share_ = share() * std::max(0.6f, 1 / std::sqrt(slowness));
            if (growing_) patience_ = std::min(2 * patience_, 32);
            growing_ = false;
            waited_ = 0;
        } else if (slowness < 0.9f && ++waited_ >= patience_) {
            share_ = share() * std::min(1.2f, std::pow(slowness, -0.2f));
            growing_ = true;
        } else if (growing_) {  // it has reached the band
            patience_ = std::max(patience_ / 2, 1);
            growing_ = false;
        }
    }

    float share_ = 1, most_ = 1;
    bool growing_ = false;
    int patience_ = 1, waited_ = 0;     // decisions between a cut and the growth after it
    float told_ = 1;                    // the share that the user was told last
    double seconds_ = 0, longest_ = 0;  // of the frames since the last decision
    int frames_ = 0, steps_ = 0;
};

struct Range {  // of flakes, by their index
    GLint first;
    GLsizei count;
};

// Where they stand in a buffer, in bytes.
inline GLintptr begin_of(Range flakes)
{
    return flakes.first * GLintptr(sizeof(snow::Particle));
}
inline GLsizeiptr size_of(Range flakes)
{
    return flakes.count * GLsizeiptr(sizeof(snow::Particle));
}

// The flakes that are moved and drawn: of each emitter's half of the pool the first part. The
// others wait, as they are, for better times.
class LiveFlakes {
public:
    explicit LiveFlakes(unsigned particles) : particles_(int(particles)) { set(1); }

    // Lets this share of all flakes live. `now` is the buffer that holds them; what is put to rest
    // is copied to `other`, so that it is found there, too, when the two have changed roles.
    void resize(float share, GLuint now, GLuint other)
    {
        const std::array<Range, 2> before = halves_;
        set(share);
        for (int i = 0; i < 2; ++i) {
            const GLintptr resting = begin_of(halves_[i]) + size_of(halves_[i]);
            const GLintptr end = begin_of(before[i]) + size_of(before[i]);
            if (resting >= end) continue;
            glBindBuffer(GL_COPY_READ_BUFFER, now);
            glBindBuffer(GL_COPY_WRITE_BUFFER, other);
            glCopyBufferSubData(GL_COPY_READ_BUFFER, GL_COPY_WRITE_BUFFER, resting, resting,
                                end - resting);
        }
    }

    const Range* begin() const { return halves_.data(); }
    const Range* end() const { return halves_.data() + 2; }

    // How many flakes each one that lives stands for.
    float weight() const
    {
        return float(std::max(1, particles_)) /
               float(std::max(1, halves_[0].count + halves_[1].count));
    }

private:
    void set(float share)
    {
        const int half = particles_ / 2, rest = particles_ - half;
        halves_ = {{{0, int(std::ceil(share * float(half)))},
                    {half, int(std::ceil(share * float(rest)))}}};
    }

    int particles_;
    std::array<Range, 2> halves_{};
};
