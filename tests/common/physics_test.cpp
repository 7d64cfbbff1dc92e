// The physics of snow.glsl, as C++ sees it.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <stdexcept>

#include "common/weather.hpp"
#include "step01_cpu_points/update.hpp"

using namespace snow;

namespace {

// Snow without what makes flakes differ: each falls straight, at the same speed.
Weather calm_weather(float terminal_speed)
{
    Weather weather = make_weather("snow", 2, 1);
    weather.turbulence = 0;
    weather.variation = 0;
    weather.emitters[0].terminal_speed = weather.emitters[1].terminal_speed = terminal_speed;
    return weather;
}

bool finite(const Particle& p)
{
    return std::isfinite(dot(p.position, p.position)) &&
           std::isfinite(dot(p.velocity, p.velocity)) && std::isfinite(p.age) &&
           std::isfinite(p.rest);
}

}  // namespace

// With u the velocity relative to the air and t the terminal speed, a step gives
//     u' = u + dt (g - k u + r),   k = min(|g| |u| / t^2, 1/dt),   |r| <= R = sqrt(3) turbulence.
// As dt k <= 1, |u'| <= f(|u|) with f(s) = s (1 - dt k) + dt (|g| + R). Where k is not cut off, f
// is the parabola s - dt |g| s^2 / t^2 + dt (|g| + R), with the fixed point s* = t sqrt(1 + R /
// |g|) and its maximum at m = t^2 / (2 dt |g|); where it is, f = dt (|g| + R). If s* < m, f rises
// up to s*: from rest a flake never gets beyond s*. Else f(m) = m / 2 + dt (|g| + R) <= s* / 2 + dt
// (|g| + R).
float fastest(uint index, const Weather& weather)
{
    const float gravity = length(weather.gravity), push = std::sqrt(3.0f) * weather.turbulence;
    const float balance = terminal_speed(index, weather) * std::sqrt(1 + push / gravity);
    return std::max(balance, balance / 2 + weather.time_step * (gravity + push));
}

TEST(Physics, SpeedNeverExceedsTerminalSpeedPlusWindPlusTurbulence)
{
    for (const char* preset : {"snow", "rain", "hail"}) {
        for (const vec3 wind : {vec3(0), vec3(3, 0, -4), vec3(30, 0, 30)}) {
            Weather weather = make_weather(preset, 2000, 5);
            weather.wind = wind;
            std::vector<Particle> flakes = make_flakes(weather);
            for (uint step = 0; step < 1500; ++step) {
                update_in_one_loop(flakes, step, weather);
                for (uint i = 0; i < flakes.size(); ++i) {
                    // 1.0001: each of some hundred steps rounds at the seventh digit.
                    ASSERT_LE(length(flakes[i].velocity),
                              1.0001f * (fastest(i, weather) + length(wind)))
                        << preset << ", flake " << i << ", step " << step;
                }
            }
        }
    }
}

// The field is made of parabolas, of which a central difference gives the slope exactly, but for
// rounding, unless it reaches across a point where two of them meet: there are four in a period.
TEST(Vortices, HaveNoDivergenceAndTurn)
{
    Weather weather = calm_weather(1);
    weather.swirl = 2;
    weather.wind = vec3(1, 0, -3);
    const uint tick = 100;
    const float h = weather.vortex_size / 32;  // m
    const int count = 16;                      // places along each axis, a period apart in all
    const auto at = [&](vec3 place) { return vortices(place, tick, weather); };
    float fastest_x = 0, turning = 0;
    for (int i = 0; i < count * count * count; ++i) {
        const vec3 cell(i % count, i / count % count, i / count / count);
        const vec3 drift = weather.wind + weather.swirl * vec3(0.3f, 0, 0.2f);
        const vec3 place = float(tick) * weather.time_step * drift +
                           2 * weather.vortex_size * (cell + 0.5f) / float(count);
        float divergence = 0;
        vec3 curl(0);
        for (int axis = 0; axis < 3; ++axis) {
            vec3 step(0);
            step[axis] = h;
            const vec3 slope = (at(place + step) - at(place - step)) / (2 * h);
            divergence += slope[axis];
            curl[(axis + 2) % 3] += slope[(axis + 1) % 3];
            curl[(axis + 1) % 3] -= slope[(axis + 2) % 3];
        }
        EXPECT_NEAR(divergence, 0, 1e-4f);  // of speeds of some 1 m/s, over 0.25 m, at seven digits
        turning = std::max(turning, length(curl));
        fastest_x = std::max(fastest_x, std::abs(at(place).x));
        EXPECT_LE(std::abs(at(place).x), weather.swirl);
    }
    EXPECT_GT(fastest_x, 0.8f * weather.swirl);
    EXPECT_GT(turning, 1);              // a second
    EXPECT_EQ(at(vec3(1, 0, 2)).y, 0);  // through the ground
}

TEST(Vortices, LeaveNoTraceWhereThereAreNone)
{
    Weather weather = make_weather("snow", 2000, 3);
    weather.wind.x = 2;
    std::vector<Particle> without = make_flakes(weather), with_faint = without;
    for (uint tick = 0; tick < 900; ++tick) {
        update_in_one_loop(without, tick, weather);
        Weather faint = weather;
        faint.swirl = 1e-30f;  // too slow for any bit, but computed
        update_in_one_loop(with_faint, tick, faint);
    }
    EXPECT_EQ(std::memcmp(without.data(), with_faint.data(), without.size() * sizeof(Particle)), 0);
}

TEST(Physics, FlakeInCalmAirReachesItsTerminalSpeed)
{
    const Weather weather = calm_weather(1.5f);
    Particle flake = born(0, 0, weather);
    for (uint step = 0; step < 120; ++step)
        flake = accelerate(move(flake, weather), weather.wind, 0, step, weather);
    EXPECT_NEAR(flake.velocity.y, -1.5f,
                1e-4f);  // what is left of the way there after 13 time constants
}

// Fall from rest with quadratic drag has an exact solution: v = -t tanh(g s / t) and
// y = -(t^2 / g) ln cosh(g s / t) after s seconds. Half the step must leave half the error.
TEST(Physics, EulerStepConvergesWithOrderOne)
{
    const double terminal = 5, gravity = 9.81, duration = 0.5;
    const double x = gravity * duration / terminal;
    const double exact_speed = -terminal * std::tanh(x);
    const double exact_height = -terminal * terminal / gravity * std::log(std::cosh(x));
    double speed_error = 0, height_error = 0;
    for (int steps = 30; steps <= 240; steps *= 2) {
        Weather weather = calm_weather(float(terminal));
        weather.time_step = float(duration / steps);
        Particle flake{};
        for (int n = 0; n < steps; ++n)
            flake = accelerate(move(flake, weather), weather.wind, 0, uint(n), weather);
        const double speed = std::abs(flake.velocity.y - exact_speed);
        const double height = std::abs(flake.position.y - exact_height);
        if (steps > 30) {
            // 0.1: the error has a part of second order, which at the largest step (1/60 s) is a
            // tenth of the first; rounding (some 1e-6) is a hundredth of the smallest error here.
            EXPECT_NEAR(std::log2(speed_error / speed), 1, 0.1) << steps << " steps";
            EXPECT_NEAR(std::log2(height_error / height), 1, 0.1) << steps << " steps";
        }
        speed_error = speed;
        height_error = height;
    }
}

// Counts births, by second and emitter, of a pool of 10,000 snowflakes over two minutes.
std::vector<uvec2> births_by_second(uint seed)
{
    const Weather weather = make_weather("snow", 10000, seed);
    std::vector<Particle> flakes = make_flakes(weather);
    std::vector<uvec2> births(120);
    for (uint step = 0; step < 60 * births.size(); ++step) {
        update_in_one_loop(flakes, step, weather);
        for (uint i = 0; i < flakes.size(); ++i) {
            if (flakes[i].age == 0.0f) ++births[step / 60][of_first_emitter(i, weather) ? 0 : 1];
        }
    }
    return births;
}

// The births of a second grow in proportion to the time, for half as long as a flake falls: 3.5 s
// to 4.7 s. Then they stay as many, without the burst and the gap of a common start.
TEST(Release, StartsThinAndHasNeitherBurstNorGap)
{
    for (const uint seed : {1u, 7u}) {
        const std::vector<uvec2> births = births_by_second(seed);
        float steady = 0;  // flakes a second, mean of the second minute
        for (size_t second = 60; second < 120; ++second) {
            steady += float(births[second].x + births[second].y) / 60;
        }
        for (size_t second = 0; second < 60; ++second) {
            const float born = float(births[second].x + births[second].y) / steady;
            EXPECT_LE(born, 1.2f) << "second " << second << ", seed " << seed;
            // 0.06: of up to 800 births, which scatter by 3 %; and half of the flakes are slower.
            const float part = (float(second) + 0.5f) / 4;
            if (second < 4) {
                EXPECT_NEAR(born, part, 0.06f) << "second " << second << ", seed " << seed;
            } else if (second > 4) {
                EXPECT_GE(born, 0.8f) << "second " << second << ", seed " << seed;
            }
        }
    }
}

TEST(Release, IsSharedEquallyByBothEmitters)
{
    uvec2 births(0);
    for (const uvec2& second : births_by_second(7)) births += second;
    // 2 %: 50,000 births each scatter by 0.4 %, and a cycle is whole steps long, of which it has
    // 700.
    EXPECT_NEAR(float(births.x) / float(births.y), 1, 0.02f);
}

// Flakes of emitter 0 in the air, by whole m of height.
std::vector<float> flakes_by_height(const std::vector<Particle>& flakes, const Weather& weather)
{
    std::vector<float> found(9);
    for (uint i = 0; of_first_emitter(i, weather); ++i) {
        if (airborne(flakes[i])) ++found[size_t(flakes[i].position.y)];
    }
    return found;
}

// The start is no front with the whole of the snow right behind it (Patrick 2000, figure A2): there
// is the more snow the higher one looks and the longer one waits (A3), until it is the same all the
// way down. The cloud's lower edge is at 7.5 m; all flakes pass through what is below.
TEST(Release, ThickensWithHeightAndTime)
{
    const Weather weather = make_weather("snow", 100000, 3);
    std::vector<Particle> flakes = make_flakes(weather);
    std::vector<std::vector<float>> density;  // by second and height
    for (uint step = 0; step <= 60 * 25; ++step) {
        if (step % 60 == 0) density.push_back(flakes_by_height(flakes, weather));
        update_in_one_loop(flakes, step, weather);
    }
    const std::vector<float> steady = density.back();
    for (size_t height = 0; height < 7; ++height) {
        // 0.2: further down a tenth has sublimated, and new flakes, which still are slow, are
        // closer together.
        EXPECT_NEAR(steady[height] / steady[6], 1, 0.2) << height << " m";
        for (size_t second = 1; second < density.size(); ++second) {
            const float now = density[second][height] / steady[height];
            const float before = density[second - 1][height] / steady[height];
            // A layer takes 4 s to fill, at a quarter a second; a front would fill it in one.
            EXPECT_LT(now - before, 0.35f) << height << " m, second " << second;
            if (second > 14) {
                EXPECT_NEAR(now, 1, 0.1) << height << " m, second " << second;
            }
            if (second > 7 || height > 5) continue;
            EXPECT_LE(density[second][height], density[second][height + 1]) << height << " m";
        }
    }
}

// Lifetimes last from a tenth of their mean to nearly twice as long, 4 s to 76 s, and flakes fall
// for some 8 s: those that live for less sublimate in the air, which is a tenth of all releases.
TEST(Release, ATenthOfTheFlakesSublimatesOnItsWay)
{
    const Weather weather = make_weather("snow", 10000, 3);
    std::vector<Particle> flakes = make_flakes(weather), before;
    float landed = 0, sublimated = 0;
    for (uint step = 0; step < 60 * 60; ++step) {
        before = flakes;
        update_in_one_loop(flakes, step, weather);
        if (step < 60 * 20) continue;  // until births come evenly
        for (uint i = 0; i < flakes.size(); ++i) {
            if (flakes[i].age != 0 || before[i].age < 0) continue;
            ++(before[i].rest > 0 ? landed : sublimated);
            if (before[i].rest == 0) {
                EXPECT_GT(before[i].age, 4 - 2 * weather.time_step);
            }
        }
    }
    EXPECT_NEAR(sublimated / (landed + sublimated), 0.1, 0.02);
}

// Who lives long is not who falls fast: of the two numbers neither tells the other.
TEST(Release, LifetimeIsIndependentOfSpeed)
{
    const Weather weather = make_weather("snow", 20000, 3);
    double correlation = 0, alive = 0;
    for (uint i = 0; i < weather.particles; ++i) {
        const double life = lifetime(i, weather) / weather.lifetime - 1;
        correlation += life / lifetime_spread * (individuality(i, weather) - 1) / weather.variation;
        alive += lifetime(i, weather) > 30;
    }
    // Of 20,000 products, whose variance is 1/9: their mean scatters by 0.0024.
    EXPECT_NEAR(correlation / weather.particles, 0, 0.01);
    // sqrt(0.64 * 0.36 / 20,000) = 0.0034.
    EXPECT_NEAR(alive / weather.particles, part_alive(30, weather), 0.015);
}

// All corners of the box of settings that --set accepts.
TEST(Physics, StaysFiniteAndAboveGroundInTheWildestWeather)
{
    Weather weather = make_weather("snow", 16, 0);
    const std::vector<Parameter> parameters = weather_parameters(weather);
    for (uint corner = 0; corner < 1u << parameters.size(); ++corner) {
        weather.seed = corner;
        for (size_t i = 0; i < parameters.size(); ++i) {
            parameters[i].set(corner >> i & 1 ? parameters[i].maximum : parameters[i].minimum);
        }
        std::vector<Particle> flakes = make_flakes(weather);
        for (Particle& flake : flakes) flake.age *= 0.01f;  // no long wait for the first birth
        for (uint step = 0; step < 400; ++step) update_in_one_loop(flakes, step, weather);
        for (const Particle& flake : flakes) {
            ASSERT_TRUE(finite(flake)) << "corner " << corner;
            ASSERT_GE(flake.position.y, 0) << "corner " << corner;
        }
    }
}

TEST(Physics, LandedFlakeRestsMeltsAndIsRebornInItsCloud)
{
    const Weather weather = make_weather("snow", 2, 1);
    Particle flake = born(1, 0, weather);
    uint step = 1;
    while (flake.rest == 0 && step < 2000) flake = advance(flake, 1, step++, weather);
    EXPECT_EQ(flake.position.y, 0);
    EXPECT_EQ(flake.velocity, vec3(0));

    const vec3 place = flake.position;
    const uint landed = step;
    while (flake.rest > 0) {
        EXPECT_EQ(flake.position, place);
        flake = advance(flake, 1, step++, weather);
    }
    EXPECT_NEAR(float(step - landed) * weather.time_step, weather.melt_time, 2 * weather.time_step);
    EXPECT_EQ(flake.age, 0);
    const Emitter& cloud = weather.emitters[1];
    EXPECT_LE(abs(flake.position.y - cloud.centre.y), cloud.half_size.y);
}

TEST(Physics, FlakeLiesForItsMeltTimeHoweverShortItsLifetime)
{
    Weather weather = make_weather("snow", 2, 1);
    weather.melt_time = 60;
    weather.lifetime = 20;
    Particle flake = born(1, 0, weather);
    uint step = 1;
    while (flake.rest == 0 && step < 2000) flake = advance(flake, 1, step++, weather);
    ASSERT_GT(flake.rest, 0);

    const uint landed = step;
    float rest = 0;
    for (; flake.rest > 0; flake = advance(flake, 1, step++, weather)) rest = flake.rest;
    EXPECT_NEAR(rest, weather.melt_time, 2 * weather.time_step);
    EXPECT_NEAR(float(step - landed) * weather.time_step, weather.melt_time, 2 * weather.time_step);
}

TEST(Physics, FlakeThatNeverLandsIsLostAfterItsLifetime)
{
    Weather weather = calm_weather(0.1f);  // it would fall for two minutes
    weather.lifetime = 20;
    Particle flake = born(1, 0, weather);
    uint step = 1;
    for (float age = -1; flake.age > age; ++step) {
        age = flake.age;
        flake = advance(flake, 1, step, weather);
    }
    EXPECT_NEAR(float(step) * weather.time_step, lifetime(1, weather), 4 * weather.time_step);
}

TEST(Follow, MovesAFlakeByWholeWidthsOfItsCloudAndOnlyIfAsked)
{
    Weather weather = calm_weather(1);
    for (Emitter& cloud : weather.emitters) cloud.centre += vec3(100, 0, -50);
    Particle flake{{0, 3, 1}, 5, {1, -1, 2}, 0};
    EXPECT_EQ(wrapped(flake, 0, weather).position, flake.position);
    weather.follow = 1;
    const Particle there = wrapped(flake, 0, weather);
    EXPECT_EQ(there.position, vec3(96, 3, -47));  // 6 and -3 times 16 m
    EXPECT_EQ(there.velocity, flake.velocity);
    EXPECT_EQ(there.age, flake.age);
    EXPECT_EQ(wrapped(there, 0, weather).position, there.position);
    EXPECT_FALSE(gone(there, 0, weather));
    flake.rest = 1;
    EXPECT_EQ(wrapped(flake, 0, weather).position, flake.position);  // it lies
    EXPECT_FALSE(gone(flake, 0, weather));
    flake.age = -1;
    flake.rest = 0;
    EXPECT_EQ(wrapped(flake, 0, weather).position, flake.position);  // it waits
}

// Explicit loops, a call for each flake: the order of the work is all that differs.
TEST(Update, AllLoopsAgreeToTheLastBit)
{
    for (const uint particles : {0u, 1u, 63u, 64u, 65u, 1000u}) {
        for (const char* preset : {"snow", "hail"}) {
            const Weather weather = make_weather(preset, particles, 3);
            std::vector<Particle> one = make_flakes(weather), three = one, plain = one;
            for (uint step = 0; step < 1500; ++step) {
                update_in_one_loop(one, step, weather);
                update_in_three_loops(three, step, weather);
                update_plainly(plain, step, weather);
            }
            const size_t bytes = particles * sizeof(Particle);
            if (bytes == 0) continue;
            EXPECT_EQ(std::memcmp(one.data(), three.data(), bytes), 0)
                << preset << " " << particles;
            EXPECT_EQ(std::memcmp(one.data(), plain.data(), bytes), 0)
                << preset << " " << particles;
        }
    }
}

// In std140 a vec3 and an array of structs begin at multiples of 16, as does what follows a struct.
// All else packs as in C++: four bytes after four bytes. (test_one_snowfall.py proves it for the
// GPU.)
TEST(Weather, LiesInMemoryAsStd140Says)
{
    for (const size_t offset : {offsetof(Weather, gravity), offsetof(Weather, wind),
                                offsetof(Weather, emitters), offsetof(Emitter, centre),
                                offsetof(Emitter, half_size), sizeof(Emitter), sizeof(Weather)}) {
        EXPECT_EQ(offset % 16, 0u);
    }
}

TEST(Weather, KnowsItsPresetsAndNoOthers)
{
    for (const char* preset : {"snow", "rain", "hail"}) {
        Weather weather = make_weather(preset, 100, 1);
        EXPECT_LT(weather.emitters[0].terminal_speed, weather.emitters[1].terminal_speed) << preset;
        EXPECT_LT(weather.emitters[0].diameter, weather.emitters[1].diameter) << preset;
        for (const Parameter& parameter : weather_parameters(weather)) {
            EXPECT_GE(parameter.get(), parameter.minimum) << preset << " " << parameter.name;
            EXPECT_LE(parameter.get(), parameter.maximum) << preset << " " << parameter.name;
        }
    }
    EXPECT_THROW(make_weather("sunshine", 100, 1), std::invalid_argument);
}

// Pearson's test: the sum of (found - expected)^2 / expected over n bins is n - 1 on average, with
// a standard deviation of sqrt(2 (n - 1)). Six of these never happen by chance; a poor hash has
// hundreds.
double chi_squared(const std::vector<int>& bins, double expected)
{
    double sum = 0;
    for (const int found : bins) sum += (found - expected) * (found - expected) / expected;
    return sum;
}

TEST(Random, IsUniformOverFlakesOverStepsAndOverPairsOfStreams)
{
    const Weather weather = make_weather("snow", 65536, 7);
    constexpr int count = 65536, bins = 256;
    const double most = bins - 1 + 6 * std::sqrt(2.0 * (bins - 1));
    for (uint stream = 0; stream < 7; ++stream) {
        std::vector<int> flakes(bins), steps(bins), pairs(bins);
        for (uint n = 0; n < count; ++n) {
            const float value = random_unit(n, 17, stream, weather);
            ASSERT_TRUE(value >= 0 && value < 1);
            ++flakes[size_t(value * bins)];
            ++steps[size_t(random_unit(17, n, stream, weather) * bins)];
            const float other = random_unit(n, 17, stream + 1, weather);
            ++pairs[size_t(value * 16) * 16 + size_t(other * 16)];
        }
        EXPECT_LT(chi_squared(flakes, count / bins), most) << "stream " << stream;
        EXPECT_LT(chi_squared(steps, count / bins), most) << "stream " << stream;
        EXPECT_LT(chi_squared(pairs, count / bins), most) << "stream " << stream;
    }
}

// A bit of the input turns each bit of the output over half the time ("avalanche").
TEST(Random, HashMixesEveryBitIntoEveryBit)
{
    constexpr int count = 20000;
    for (uint in = 0; in < 32; ++in) {
        int turned[32] = {};
        for (uint n = 0; n < count; ++n) {
            const uint change = hash(n) ^ hash(n ^ 1u << in);
            for (uint out = 0; out < 32; ++out) turned[out] += int(change >> out & 1);
        }
        // 0.05: a bit that does not depend on the input turns never or always; chance alone is
        // 0.004.
        for (uint out = 0; out < 32; ++out) {
            EXPECT_NEAR(turned[out] / double(count), 0.5, 0.05) << in << " -> " << out;
        }
    }
}
