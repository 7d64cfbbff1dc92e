// The flakes that are moved and drawn while the others wait.
#pragma once

#include <GL/glew.h>

#include <array>

#include "common/snow.hpp"
#include "step04_transform_feedback/ping_pong.hpp"

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

// Of each emitter's half of the pool the first part. The others wait, as they are, for better
// times.
class LiveFlakes {
public:
    explicit LiveFlakes(unsigned particles);

    // Lets this share of all flakes live. What is put to rest is copied to the other of the two
    // buffers, so that it is found there, too, when they have changed roles.
    void resize(float share, const PingPong& particles);

    const Range* begin() const { return halves_.data(); }
    const Range* end() const { return halves_.data() + 2; }

    // How many flakes each one that lives stands for.
    float weight() const;

private:
    void set(float share);

    int particles_;
    std::array<Range, 2> halves_{};
};
