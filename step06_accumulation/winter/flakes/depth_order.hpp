// The order in which flakes hide each other: from the farthest to the nearest.
#pragma once

#include <GL/glew.h>

#include "common/program.hpp"
#include "step06_accumulation/winter/budget/live_flakes.hpp"

class DepthOrder {
public:
    DepthOrder();

    // Sorts the flakes that live by their distance from the camera of camera.glsl, on the card.
    void sort(const PingPong& particles, const LiveFlakes& live);

    // Draws them as points in that order, with the vertex array that is bound.
    void draw() const;

    // The flakes by their index, farthest first: for tests.
    GLuint order() const { return order_; }

private:
    Program measure_, exchange_;
    GlObject distances_, order_;
    GLsizei count_ = 0;
    GLuint places_ = 0;  // a power of two
};
