// What the snow looks like, everywhere, in a texture: see smooth.comp.
#pragma once

#include <GL/glew.h>

#include "common/program.hpp"
#include "step06_accumulation/cover/columns.hpp"

class SmoothSnow {
public:
    // For a grid with that many voxels along each edge.
    SmoothSnow(const Columns& columns, int resolution);

    // What the last `ticks` time steps, up to number `tick`, have changed.
    void update(unsigned tick, int ticks);

    GLuint texture() const { return texture_; }

private:
    const Columns& columns_;
    Program program_;
    GlObject texture_;
};
