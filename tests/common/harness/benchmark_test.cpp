// What many frame times come to, and which frames are timed.
#include "common/harness/benchmark.hpp"

#include <gtest/gtest.h>

#include <numeric>

TEST(Benchmark, TimesTheFramesAfterTheWarmUpAndInSoftwareSomeBefore)
{
    CommandLine command;
    command.warmup = 10;
    command.benchmark = true;
    EXPECT_EQ(timing_of_frame(command, 0, true), Timing::off);
    EXPECT_EQ(timing_of_frame(command, 4, true), Timing::off);
    EXPECT_EQ(timing_of_frame(command, 5, true), Timing::synchronised);
    EXPECT_EQ(timing_of_frame(command, 9, true), Timing::synchronised);
    EXPECT_EQ(timing_of_frame(command, 10, true), Timing::queries);
    EXPECT_EQ(timing_of_frame(command, 9, false), Timing::off) << "a card's timestamps will do";
    command.benchmark = false;
    EXPECT_EQ(timing_of_frame(command, 9, true), Timing::off);
}

TEST(Benchmark, QuantilesAreRanks)
{
    EXPECT_EQ(quantile({}, 0.5), 0);
    EXPECT_EQ(quantile({7}, 0.95), 7);
    EXPECT_EQ(quantile({3, 1, 2}, 0.5), 2);
    std::vector<double> hundred(100);
    std::iota(hundred.begin(), hundred.end(), 0);
    EXPECT_EQ(quantile(hundred, 0.95), 95);
    EXPECT_EQ(quantile(hundred, 1), 99);
}
