// The grain of snow seen from close by, as a texture that repeats.
#pragma once

#include "common/gl_object.hpp"

// Red and green: how the surface leans along x and z, 0.5 is level; blue: how high it is; alpha: a
// number of each texel's own. Computed from noise of several sizes.
GlObject make_grain();
