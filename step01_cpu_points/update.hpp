// The motion of all flakes on the CPU: one time step, in one loop over the array or in three.
// Both give the same flakes to the last bit.
#pragma once

#include <span>

#include "common/snow.hpp"

namespace snow {

// Births are rare (one flake in some 700 a step) and branch, so they stay out of the loops that the
// compiler vectorises: those only find out whether a block of flakes, still in the cache, has any.
// The weather is passed by value to all three: behind a reference it might be changed by any write
// to a flake, for all the compiler knows, and would have to be read again for each.
constexpr size_t block = 64;

inline void give_birth(std::span<Particle> flakes, size_t begin, size_t end, uint tick,
                       Weather weather)
{
    int any = 0;
    for (size_t i = begin; i < end; ++i) any |= gone(flakes[i], uint(i), weather);
    if (!any) return;
    for (size_t i = begin; i < end; ++i) {
        if (gone(flakes[i], uint(i), weather)) flakes[i] = born(uint(i), tick, weather);
    }
}

// Everything that happens to a flake, then the next flake: each is loaded and stored once.
inline void update_in_one_loop(std::span<Particle> flakes, uint tick, Weather weather)
{
    for (size_t begin = 0; begin < flakes.size(); begin += block) {
        const size_t end = min(begin + block, flakes.size());
        for (size_t i = begin; i < end; ++i) {
            Particle p = flakes[i];
            p = settle(move(p, weather), weather);
            p = accelerate(p, weather.wind, uint(i), tick, weather);
            flakes[i] = p;
        }
        give_birth(flakes, begin, end, tick, weather);
    }
}

// The same in three trips through memory: all positions, then all velocities, then all births.
inline void update_in_three_loops(std::span<Particle> flakes, uint tick, Weather weather)
{
    for (Particle& flake : flakes) flake = settle(move(flake, weather), weather);
    for (size_t i = 0; i < flakes.size(); ++i)
        flakes[i].velocity = accelerate(flakes[i], weather.wind, uint(i), tick, weather).velocity;
    for (size_t begin = 0; begin < flakes.size(); begin += block) {
        give_birth(flakes, begin, min(begin + block, flakes.size()), tick, weather);
    }
}

}  // namespace snow
