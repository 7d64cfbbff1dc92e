// The order in which flakes hide each other: from the farthest to the nearest.
#pragma once

#include <GL/glew.h>

#include "common/program.hpp"
#include "step04_transform_feedback/particle_buffer.hpp"
#include "step06_accumulation/winter/flake_budget.hpp"

class DepthOrder {
public:
    explicit DepthOrder(unsigned particles);

    // Sorts the flakes that live by their distance from the camera of frame.glsl, on the card.
    void sort(const ParticleBuffer& particles, const LiveFlakes& live);

    // Draws them as points in that order, with the vertex array that is bound.
    void draw() const;

    // The flakes by their index, farthest first: for tests.
    GLuint order() const { return order_; }

private:
    Program measure_, exchange_;
    GlObject distances_, order_;
    GLsizei count_ = 0;  // of those that live
    GLuint size_;        // of the buffers: a power of two
};
