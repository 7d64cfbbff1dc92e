// The physics of snow.glsl for C++.
#pragma once

#include <cstddef>
#include <glm/glm.hpp>

namespace snow {
using namespace glm;
#include "common/snow.glsl"

static_assert(sizeof(Particle) == 32 && offsetof(Particle, velocity) == 16,
              "eight floats, no gaps");
static_assert(sizeof(Emitter) == 32 && sizeof(Weather) == 160 && offsetof(Weather, emitters) == 96,
              "the layout std140 gives them");
}  // namespace snow
