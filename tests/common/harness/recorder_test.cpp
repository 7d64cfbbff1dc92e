// Which pictures a frame leaves, without a window to take them of.
#include "common/harness/recorder.hpp"

#include <gtest/gtest.h>
#include <unistd.h>

#include <set>

namespace fs = std::filesystem;

namespace {

class RecordFrame : public testing::Test {
protected:
    void SetUp() override
    {
        folder = fs::path(testing::TempDir()) / ("snowfall_record_" + std::to_string(getpid()));
        fs::create_directories(folder / "film");
        before = fs::current_path();
        fs::current_path(folder);
        command.lesson.name = "step";
    }
    void TearDown() override
    {
        fs::current_path(before);
        fs::remove_all(folder);
    }

    // The files that a frame leaves.
    std::set<std::string> files(unsigned number, bool last, bool asked)
    {
        grabbed = 0;
        record_frame(command, number, last, asked, [this] {
            ++grabbed;
            return Picture{{2, 1}, {255, 0, 0, 0, 255, 0}};
        });
        std::set<std::string> names;
        for (const auto& entry : fs::recursive_directory_iterator(folder)) {
            if (entry.is_regular_file()) names.insert(entry.path().filename().string());
        }
        return names;
    }

    CommandLine command;
    fs::path folder, before;
    int grabbed = 0;
};

}  // namespace

TEST_F(RecordFrame, LeavesNothingUnlessAsked)
{
    command.screenshot = folder / "last.png";
    EXPECT_TRUE(files(1, false, false).empty());
    EXPECT_EQ(grabbed, 0);
}

TEST_F(RecordFrame, LeavesTheLastFrameAndTheOneThatTheUserAskedFor)
{
    command.screenshot = folder / "last.png";
    EXPECT_EQ(files(1, false, true), std::set<std::string>{"step.png"});
    EXPECT_EQ(files(2, true, false), (std::set<std::string>{"last.png", "step.png"}));
    EXPECT_EQ(grabbed, 1);
}

TEST_F(RecordFrame, LeavesEveryFrameThatCounts)
{
    command.record = folder / "film";
    EXPECT_TRUE(files(0, false, false).empty()) << "of the warm-up";
    EXPECT_EQ(files(1, false, false), std::set<std::string>{"000001.png"});
    EXPECT_EQ(files(2, true, false), (std::set<std::string>{"000001.png", "000002.png"}));
}
