// The physics of snow.glsl for C++, and the weather it runs in.
#pragma once

#include <cstddef>
#include <glm/glm.hpp>
#include <span>
#include <string>
#include <vector>

namespace snow {
using namespace glm;
#include "common/snow.glsl"

static_assert(sizeof(Particle) == 32 && offsetof(Particle, velocity) == 16,
              "eight floats, no gaps");
static_assert(sizeof(Emitter) == 32 && sizeof(Weather) == 160, "the layout std140 gives them");

// Largest pool a program accepts: 1.6 GB of flakes, and an index that a GLsizei holds.
constexpr uint max_particles = 50'000'000;

// One number of the weather that a user may set: `--set name=value`.
struct Parameter {
    const char* name;
    const char* unit;
    float least, most;
    const char* meaning;
    float& (*value)(Weather&);
};
std::span<const Parameter> weather_parameters();

// The weather called "snow", "rain" or "hail", for a pool of that many flakes.
Weather make_weather(const std::string& preset, uint particles, uint seed);

// Every flake of the pool, waiting to be born.
std::vector<Particle> make_flakes(const Weather& weather);

}  // namespace snow
