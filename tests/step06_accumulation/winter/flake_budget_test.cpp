// The controller of the frame rate, with a simulated program under it.
#include "step06_accumulation/winter/flake_budget.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>
#include <vector>

namespace {

// What frames cost, s: something in any case, something for drawing all flakes, and something for
// every step they make. The steps follow the clock, as in Window.
struct Simulation {
    double fixed, draw, update;
    double noise = 0.1;  // relative, either way

    FlakeBudget budget{};
    double time = 0, owed = 0;
    std::mt19937 generator{1};
    std::vector<double> times{}, shares{};

    void run(double seconds, float fps, double load = 0)
    {
        for (const double end = time + seconds; time < end;) {
            const double before = times.empty() ? 0.01 : time - times.back();
            owed = std::min(owed + before, 8 / 60.0);
            const int steps = int(owed * 60);
            owed -= steps / 60.0;
            budget.frame(before, steps, fps, 1);
            times.push_back(time);
            shares.push_back(double(budget.share()));
            const double cost = fixed + load + double(budget.share()) * (draw + update * steps);
            time += cost * std::uniform_real_distribution(1 - noise, 1 + noise)(generator);
        }
    }

    double mean_fps(double begin, double end) const
    {
        int frames = 0;
        for (const double t : times) frames += t >= begin && t < end;
        return frames / (end - begin);
    }

    double share_at(double t) const
    {
        size_t i = 0;
        while (i + 1 < times.size() && times[i + 1] <= t) ++i;
        return shares[i];
    }

    // The largest share over the smallest.
    double swing(double begin, double end) const
    {
        double least = 1, most = 0;
        for (size_t i = 0; i < times.size(); ++i) {
            if (times[i] < begin || times[i] >= end) continue;
            least = std::min(least, shares[i]);
            most = std::max(most, shares[i]);
        }
        return most / least;
    }
};

// Frames that depend on the flakes mildly, fully, and steeply (where steps must be caught up).
std::vector<Simulation> programs()
{
    return {{0.010, 0.010, 0.001}, {0.001, 0.020, 0.002}, {0.006, 0.002, 0.014}};
}

}  // namespace

TEST(FlakeBudget, KeepsAllFlakesUnlessAskedAndWhereThereIsTimeForThem)
{
    Simulation slow{0.1, 0.4, 0.1}, fast{0.001, 0.002, 0.001};
    slow.run(20, 0);
    fast.run(20, 60);
    for (const Simulation& program : {slow, fast})
        EXPECT_EQ(*std::min_element(program.shares.begin(), program.shares.end()), 1);
}

TEST(FlakeBudget, GivesWayToALoadWithinTwoSecondsAndRecovers)
{
    for (Simulation& program : programs()) {
        const float fps = 40;
        program.run(20, fps);
        const double before = program.share_at(20);
        EXPECT_GT(program.mean_fps(10, 20), 0.85 * double(fps));
        program.run(20, fps, 0.012);  // s a frame
        EXPECT_LT(program.share_at(22), 0.9 * before);
        EXPECT_GT(program.mean_fps(22, 24), 0.8 * double(fps)) << program.update;
        EXPECT_GT(program.mean_fps(30, 40), 0.85 * double(fps)) << program.update;
        program.run(20, fps);
        EXPECT_GT(program.share_at(55), 0.85 * before) << program.update;
        for (const double steady : {10, 30, 50})
            EXPECT_LT(program.swing(steady, steady + 10), 1.3) << program.update << " " << steady;
        for (size_t i = 1; i < program.shares.size(); ++i) {
            EXPECT_LT(program.shares[i], 1.25 * program.shares[i - 1]);
            EXPECT_GT(program.shares[i], 0.55 * program.shares[i - 1]);
        }
    }
}

TEST(FlakeBudget, OverlooksAHitchAndAPause)
{
    Simulation program{0.002, 0.010, 0.002};
    program.run(5, 60);
    const float before = program.budget.share();
    program.budget.frame(3, 8, 60, 1);
    program.run(1, 60);
    EXPECT_NEAR(program.budget.share(), before, 0.1f * before);
    for (int i = 0; i < 1000; ++i) program.budget.frame(0.001, 0, 60, 1);
    EXPECT_NEAR(program.budget.share(), before, 0.1f * before);
}
