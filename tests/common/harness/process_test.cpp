// Whether there is memory for the flakes: asked before they are made.
#include "common/harness/process.hpp"

#include <gtest/gtest.h>

#include <stdexcept>

TEST(Memory, TenMillionFlakesAreRefusedWhereTheyDoNotFitAndNowhereElse)
{
    EXPECT_NEAR(size_of_flakes(10'000'000), 305.2, 0.1) << "32 bytes each, MiB";
    EXPECT_NO_THROW(check_memory_for_flakes(10'000'000, false, 306));
    EXPECT_THROW(check_memory_for_flakes(10'000'000, false, 305), std::runtime_error);
    EXPECT_THROW(check_memory_for_flakes(10'000'000, true, 900), std::runtime_error);
    EXPECT_NO_THROW(check_memory_for_flakes(10'000'000, true, 920));
}

TEST(Memory, TheLineNamesWhatIsNeededWhatIsThereAndTheRemedy)
{
    try {
        check_memory_for_flakes(10'000'000, true, 500);
        FAIL();
    } catch (const std::runtime_error& error) {
        EXPECT_STREQ(error.what(),
                     "not enough memory: 10000000 flakes need 916 MiB, 500 MiB are free "
                     "(try fewer --particles)");
    }
}

TEST(Memory, TheSystemTellsHowMuchIsFree)
{
    EXPECT_GT(free_memory(), 0);
#ifdef __linux__
    EXPECT_LT(free_memory(), 1e9);
#endif
}
