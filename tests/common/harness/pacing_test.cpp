// How many time steps a frame makes, without a window to show it.
#include "common/harness/pacing.hpp"

#include <gtest/gtest.h>

#include <algorithm>

namespace {

CommandLine realtime()
{
    CommandLine command;
    command.weather = snow::make_weather("snow", 1, 1);  // steps of 1/60 s
    return command;
}

}  // namespace

TEST(Pacing, FollowsTheClockAndOwesWhatIsLess)
{
    Pacing pacing;
    Controls controls;
    const CommandLine command = realtime();
    int ticks = 0;
    for (int frame = 0; frame < 240; ++frame)
        ticks += pacing.begin_frame(command, 1 / 240.0, 1, controls);
    EXPECT_NEAR(ticks, 60, 1);  // rounding may leave the last one for the next frame
}

TEST(Pacing, SlowsDownAfterAHitchInsteadOfSkipping)
{
    Pacing pacing;
    Controls controls;
    CommandLine command = realtime();
    EXPECT_EQ(pacing.begin_frame(command, 10, 1, controls), 8);
    EXPECT_EQ(pacing.begin_frame(command, 0, 1, controls), 0);
    command.timelapse = 3;
    EXPECT_EQ(pacing.begin_frame(command, 10, 1, controls), 24);
}

TEST(Pacing, MakesTheSameStepsInEveryFrameOfARepeatableRun)
{
    Pacing pacing;
    Controls controls;
    CommandLine command = realtime();
    command.frames = 5;
    EXPECT_EQ(pacing.begin_frame(command, 0, 1, controls), 1);
    EXPECT_EQ(pacing.begin_frame(command, 10, 1, controls), 1);
    command.timelapse = 60;
    EXPECT_EQ(pacing.begin_frame(command, 0, 1, controls), 60);
}

TEST(Pacing, MakesTheStepsOfManyFramesInOneUntilTheLastOfTheWarmUp)
{
    CommandLine command = realtime();
    command.frames = 5;
    for (const unsigned warmup : {0u, 1u, 60u, 119u, 120u, 150u, 960u}) {
        command.warmup = warmup;
        Pacing pacing;
        Controls controls;
        unsigned steps = 0, alone = 0;
        while (steps < warmup) {
            const unsigned frames = frames_in_one(command, steps);
            alone = frames == 1 ? alone + 1 : 0;
            steps += unsigned(pacing.begin_frame(command, 0, frames, controls));
        }
        EXPECT_EQ(steps, warmup) << "those that count begin in the same state as ever";
        EXPECT_GE(alone, std::min(warmup, 60u));
        EXPECT_LT(alone, 120u);
        EXPECT_EQ(frames_in_one(command, warmup), 1u);
    }
    command.realtime = true;
    EXPECT_EQ(frames_in_one(command, 0), 1u) << "the clock says how many";
}

TEST(Pacing, PausesAndMakesSingleSteps)
{
    Pacing pacing;
    Controls controls;
    const CommandLine command = realtime();
    controls.paused = true;
    EXPECT_EQ(pacing.begin_frame(command, 1, 1, controls), 0);
    controls.single_step = true;
    EXPECT_EQ(pacing.begin_frame(command, 1, 1, controls), 1);
    EXPECT_EQ(pacing.begin_frame(command, 1, 1, controls), 0);
    controls.paused = false;
    EXPECT_EQ(pacing.begin_frame(command, 0, 1, controls), 0)
        << "what passed meanwhile is not caught up";
}

TEST(Pacing, MakesAsManyStepsAsAreDue)
{
    Pacing pacing;
    Controls controls;
    CommandLine command = realtime();
    command.frames = 5;
    command.timelapse = 60;
    pacing.begin_frame(command, 0, 1, controls);
    int made = 0;
    while (pacing.next_tick()) EXPECT_EQ(pacing.ticks(), ++made);
    EXPECT_EQ(made, 60);
}

TEST(Pacing, MakesNoMoreThanThereIsTimeForWhereTheClockSaysHowMany)
{
    Pacing pacing;
    Controls controls;
    CommandLine command = realtime();
    command.timelapse = 1000;
    pacing.begin_frame(command, 10, 1, controls);
    EXPECT_TRUE(pacing.next_tick());
    const auto begin = std::chrono::steady_clock::now();
    while (std::chrono::steady_clock::now() - begin < std::chrono::milliseconds(60)) {}
    EXPECT_FALSE(pacing.next_tick());
    EXPECT_EQ(pacing.ticks(), 1) << "one in any case";
}
