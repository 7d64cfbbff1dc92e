// Where every flake that was ever released has gone, counted on the GPU and read once, at the end.
#pragma once

#include <GL/glew.h>

#include <vector>

#include "common/gl_object.hpp"
#include "common/snow.hpp"

class Ledger {
public:
    Ledger();

    // Lets the shaders of ledger.glsl count in it.
    void bind() const;

    // Prints the line in which released = airborne + lying + deposited + melted + left.
    void print(const std::vector<snow::Particle>& flakes) const;

private:
    GlObject buffer_;
};
