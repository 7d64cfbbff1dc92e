// The physics of snow.glsl for C++, and the weather it runs in.
#pragma once

#include <cstddef>
#include <glm/glm.hpp>
#include <string>
#include <string_view>
#include <vector>

namespace snow {
using namespace glm;
#include "common/snow.glsl"

static_assert(sizeof(Particle) == 32 && offsetof(Particle, velocity) == 16,
              "eight floats, no gaps");
static_assert(sizeof(Emitter) == 32 && sizeof(Weather) == 160, "the layout std140 gives them");

// Largest pool a program accepts: 1.6 GB of flakes, and an index that a GLsizei holds.
constexpr uint max_particles = 50'000'000;

// A number that the user may change: `--set name=value`, or its slider in the panel.
struct Parameter {
    const char* name;
    const char* unit;
    float least, most;
    const char* meaning;
    float* value;

    bool is_switch() const { return std::string_view(unit) == "on/off"; }
};

// Those of `weather`.
std::vector<Parameter> weather_parameters(Weather& weather);

// The weather called "snow", "rain" or "hail", for a pool of that many flakes.
Weather make_weather(const std::string& preset, uint particles, uint seed);

// Every flake of the pool, waiting to be born.
std::vector<Particle> make_flakes(const Weather& weather);

}  // namespace snow
