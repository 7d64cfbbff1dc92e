// The physics of snow.glsl, as C++ sees it.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numeric>

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

// The field is made of parabolas, of which a central difference gives the slope exactly, but for
// rounding, unless it reaches across a point where two of them meet: there are four in a period.
TEST(Vortices, HaveNoDivergence)
{
    Weather weather = calm_weather(1);
    weather.swirl = 2;
    weather.wind = vec3(1, 0, -3);
    const uint tick = 100;
    const float h = weather.vortex_size / 32;  // m
    const int count = 16;                      // places along each axis, a period apart in all
    const auto at = [&](vec3 place) { return vortices(place, tick, weather); };
    float fastest_x = 0;
    for (int i = 0; i < count * count * count; ++i) {
        const vec3 cell(i % count, i / count % count, i / count / count);
        const vec3 drift = weather.wind + weather.swirl * vec3(0.3f, 0, 0.2f);
        const vec3 place = float(tick) * weather.time_step * drift +
                           2 * weather.vortex_size * (cell + 0.5f) / float(count);
        float divergence = 0;
        for (int axis = 0; axis < 3; ++axis) {
            vec3 step(0);
            step[axis] = h;
            divergence += (at(place + step) - at(place - step))[axis] / (2 * h);
        }
        EXPECT_NEAR(divergence, 0, 1e-4f);  // of speeds of some 1 m/s, over 0.25 m, at seven digits
        fastest_x = std::max(fastest_x, std::abs(at(place).x));
        EXPECT_LE(std::abs(at(place).x), weather.swirl);
    }
    EXPECT_GT(fastest_x, 0.8f * weather.swirl);
    EXPECT_EQ(at(vec3(1, 0, 2)).y, 0);  // through the ground
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

// The births of a second grow in proportion to the time, for half as long as a flake falls: 3.5 s
// to 4.7 s. Then they stay as many, without the burst and the gap of a common start.
TEST(Release, StartsThinAndHasNeitherBurstNorGap)
{
    const Weather weather = make_weather("snow", 10000, 7);
    std::vector<Particle> flakes = make_flakes(weather);
    std::vector<float> births(120);  // by second
    float of_first = 0, of_all = 0;
    for (uint step = 0; step < 60 * births.size(); ++step) {
        update_in_one_loop(flakes, step, weather);
        for (uint i = 0; i < flakes.size(); ++i) {
            if (flakes[i].age != 0) continue;
            ++births[step / 60];
            ++of_all;
            of_first += of_first_emitter(i, weather);
        }
    }
    EXPECT_NEAR(of_first / of_all, 0.5f, 0.005f);
    const float steady = std::accumulate(births.begin() + 60, births.end(), 0.0f) / 60;  // a second
    for (int second = 0; second < 60; ++second) {
        const float born = births[size_t(second)] / steady;
        EXPECT_LE(born, 1.2f) << "second " << second;
        // 0.06: of up to 800 births, which scatter by 3 %; and half of the flakes are slower.
        if (second < 4) {
            EXPECT_NEAR(born, (float(second) + 0.5f) / 4, 0.06f) << "second " << second;
        } else if (second > 4) {
            EXPECT_GE(born, 0.8f) << "second " << second;
        }
    }
}

// All corners of the box of settings that --set accepts.
TEST(Physics, StaysFiniteAndAboveGroundInTheWildestWeather)
{
    Weather weather = make_weather("snow", 6, 0);
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

// For its melt time, however short its lifetime.
TEST(Physics, LandedFlakeRestsMeltsAndIsRebornInItsCloud)
{
    Weather weather = make_weather("snow", 2, 1);
    weather.lifetime = 20;
    for (const float melt_time : {4.0f, 60.0f}) {
        weather.melt_time = melt_time;
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
        EXPECT_NEAR(float(step - landed) * weather.time_step, melt_time, 2 * weather.time_step);
        EXPECT_EQ(flake.age, 0);
        const Emitter& cloud = weather.emitters[1];
        EXPECT_LE(abs(flake.position.y - cloud.centre.y), cloud.half_size.y);
    }
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
