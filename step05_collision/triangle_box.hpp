// The test of triangle_box.glsl for C++.
#pragma once

#include "common/snow.hpp"

namespace snow {
#include "step05_collision/triangle_box.glsl"
}  // namespace snow
