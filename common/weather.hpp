// The weather in which it snows: its presets, and the numbers in it that a user may change.
#pragma once

#include <string>
#include <variant>
#include <vector>

#include "common/snow.hpp"

namespace snow {

// Largest pool a program accepts: 1.6 GB of flakes, and an index that a GLsizei holds.
constexpr uint max_particles = 50'000'000;

// The weather called "snow", "rain" or "hail", for a pool of that many flakes.
Weather make_weather(const std::string& preset, uint particles, uint seed);

// Every flake of the pool, waiting to be born.
std::vector<Particle> make_flakes(const Weather& weather);

// A number that the user may change: `--set name=value`, or its slider in the panel.
struct Parameter {
    const char* name;   // for --set
    const char* label;  // in the panel
    const char* unit;   // of a switch: "on/off"
    float minimum, maximum;
    const char* meaning;
    std::variant<float*, bool*> value;  // a number, or a switch
    char key = 0;                       // that turns a switch on and off
    const char* heading = "";           // in the panel, under which it stands
    bool costly = false;  // a switch that is off in software, unless the user has set it

    bool is_switch() const { return std::holds_alternative<bool*>(value); }

    // Read and write it as a number: a switch is 1 or 0.
    float get() const
    {
        return std::visit([](auto* now) { return float(*now); }, value);
    }
    void set(float number) const
    {
        std::visit([number](auto* now) { *now = number; }, value);
    }
};

std::vector<Parameter> weather_parameters(Weather& weather);  // those of the weather

// The same parameters, under a heading.
std::vector<Parameter> under(const char* heading, std::vector<Parameter> parameters);

}  // namespace snow
