// The grain of snow seen from close by, as a texture that repeats.
#pragma once

#include "common/gl_object.hpp"

// Red and green: how the surface leans along x and z; blue: how high it is. 0.5 is the mean.
GlObject make_grain();
