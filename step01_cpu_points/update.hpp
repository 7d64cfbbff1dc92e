// The motion of all flakes on the CPU, one time step, in four ways. All give the same flakes to the
// last bit.
#pragma once

#include <cstddef>
#include <span>
#include <stdexcept>

#include "common/snow.hpp"

namespace snow {

// Euler's method, flake by flake.
inline void update_plainly(std::span<Particle> flakes, uint tick, Weather weather)
{
    for (size_t i = 0; i < flakes.size(); ++i)
        flakes[i] = advance(flakes[i], uint(i), tick, weather);
}

// ---- The same for eight flakes at once: 5 ns a flake, where the loop above takes 13. Births,
// which are rare and branch, have a loop of their own, while the block is still in the cache. The
// weather is passed by value: behind a reference any write to a flake might change it, for all the
// compiler knows.

constexpr size_t block = 64;

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

// All positions, then all velocities, then all births: each flake goes through the cache three
// times.
inline void update_in_three_loops(std::span<Particle> flakes, uint tick, Weather weather)
{
    for (Particle& flake : flakes) flake = settle(move(flake, weather), weather);
    for (size_t i = 0; i < flakes.size(); ++i)
        flakes[i].velocity = accelerate(flakes[i], weather.wind, uint(i), tick, weather).velocity;
    for (size_t begin = 0; begin < flakes.size(); begin += block) {
        give_birth(block_at(flakes, begin), uint(begin), tick, weather);
    }
}

// The one loop, which OpenMP deals out to the processor's cores. No flake knows of another, so it
// does not matter which core moves which, and when.
inline void update_on_all_cores(std::span<Particle> flakes, uint tick, Weather weather)
{
    const auto size = std::ptrdiff_t(flakes.size());  // OpenMP 2 counts with signs
#ifdef _OPENMP
#pragma omp parallel for schedule(static) firstprivate(weather)
#else
    throw std::runtime_error("--variant threads: this compiler has no OpenMP: try one-loop");
#endif
    for (std::ptrdiff_t begin = 0; begin < size; begin += std::ptrdiff_t(block)) {
        update_block(block_at(flakes, size_t(begin)), uint(begin), tick, weather);
    }
}

}  // namespace snow
