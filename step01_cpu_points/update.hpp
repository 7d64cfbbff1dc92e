// The motion of all flakes on the CPU: one time step, in one loop over the array or in three.
// Both give the same flakes to the last bit.
#pragma once

#include <span>

#include "common/snow.hpp"

namespace snow {

// Births are rare (one flake in some 700 a step) and branch, so they stay out of the loops that the
// compiler vectorises: those only find out whether a block of flakes, still in the cache, has any.
// The weather is passed by value to all of them: behind a reference it might be changed by any
// write to a flake, for all the compiler knows, and would have to be read again for each.
constexpr size_t block = 64;

// The block of `flakes` that begins at index `begin`.
inline std::span<Particle> block_at(std::span<Particle> flakes, size_t begin)
{
    return flakes.subspan(begin, min(block, flakes.size() - begin));
}

// first: the index of the first of these flakes.
inline void give_birth(std::span<Particle> flakes, uint first, uint tick, Weather weather)
{
    const size_t count = flakes.size();
    int any = 0;
    for (size_t i = 0; i < count; ++i) any |= gone(flakes[i], first + uint(i), weather);
    if (!any) return;
    for (size_t i = 0; i < count; ++i) {
        const uint index = first + uint(i);
        if (gone(flakes[i], index, weather)) flakes[i] = born(index, tick, weather);
    }
}

// Everything that happens to a flake, then the next flake: each is loaded and stored once.
inline void update_block(std::span<Particle> flakes, uint first, uint tick, Weather weather)
{
    const size_t count = flakes.size();
    for (size_t i = 0; i < count; ++i) {
        Particle p = flakes[i];
        p = settle(move(p, weather), weather);
        p = accelerate(p, weather.wind, first + uint(i), tick, weather);
        flakes[i] = p;
    }
    give_birth(flakes, first, tick, weather);
}

inline void update_in_one_loop(std::span<Particle> flakes, uint tick, Weather weather)
{
    for (size_t begin = 0; begin < flakes.size(); begin += block) {
        update_block(block_at(flakes, begin), uint(begin), tick, weather);
    }
}

// The same in three trips through memory: all positions, then all velocities, then all births.
inline void update_in_three_loops(std::span<Particle> flakes, uint tick, Weather weather)
{
    for (Particle& flake : flakes) flake = settle(move(flake, weather), weather);
    for (size_t i = 0; i < flakes.size(); ++i)
        flakes[i].velocity = accelerate(flakes[i], weather.wind, uint(i), tick, weather).velocity;
    for (size_t begin = 0; begin < flakes.size(); begin += block) {
        give_birth(block_at(flakes, begin), uint(begin), tick, weather);
    }
}

}  // namespace snow
