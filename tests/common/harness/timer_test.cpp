// The stage timer, in a real window.
#include "common/harness/timer.hpp"

#include <gtest/gtest.h>

#include <fstream>
#include <sstream>
#include <stdexcept>

#include "common/harness/files.hpp"
#include "common/window.hpp"
#include "tests/common/harness/small_window.hpp"

namespace {

using Clock = std::chrono::steady_clock;

double milliseconds(Clock::duration time)
{
    return std::chrono::duration<double, std::milli>(time).count();
}

// Ten frames of 5 ms, timed to a file.
struct BusyRun {
    BusyRun() : path(std::filesystem::path(testing::TempDir()) / "busy.csv")
    {
        CommandLine command = small_window(1.5);
        command.frames = 10;
        command.csv = path;
        Window window(command);
        try {
            FrameTimer timer;
            timer.begin_frame(false);
            const StageTimer outer(&timer, "outer");
            const StageTimer inner(&timer, "inner");
        } catch (const std::logic_error&) {
            refuses_nesting = true;
        }
        const Clock::time_point begin = Clock::now();
        while (window.begin_frame()) {
            {
                const auto stage = window.stage("idle");
            }
            {
                const auto stage = window.stage("busy");
                const Clock::time_point start = Clock::now();
                while (Clock::now() - start < std::chrono::milliseconds(5)) {}
            }
            last_frame = Clock::now();
            window.swap_buffers();
        }
        wall_ms = milliseconds(last_frame - begin);
        std::istringstream lines(read_file(path));
        std::getline(lines, header);
        for (std::string line; std::getline(lines, line);) {
            // Behind the renderer, which is quoted because it has commas.
            std::istringstream fields(line.substr(line.rfind('"') + 2));
            std::vector<double> row;
            for (std::string field; std::getline(fields, field, ',');) {
                row.push_back(field.empty() || field == "query" ? -1 : std::stod(field));
            }
            rows.push_back(row);
        }
    }

    std::filesystem::path path;
    std::string header;
    std::vector<std::vector<double>>
        rows;  // frame, frame_ms, timing, then cpu and gpu of each stage
    Clock::time_point last_frame;
    double wall_ms = 0;
    bool refuses_nesting = false;
};

// Made once: Mesa may end a program with an X error that opens a second window.
const BusyRun& the_busy_run()
{
    static const BusyRun run;
    return run;
}

}  // namespace

TEST(Timer, FindsTheBusyStage)
{
    const BusyRun& run = the_busy_run();
    EXPECT_EQ(run.header, "step,variant,particles,width,height,renderer,frame,frame_ms,timing,"
                          "idle_cpu_ms,idle_gpu_ms,busy_cpu_ms,busy_gpu_ms");
    ASSERT_EQ(run.rows.size(), 10u);
    for (size_t i = 0; i < run.rows.size(); ++i) {
        const std::vector<double>& row = run.rows[i];
        EXPECT_EQ(row[0], double(i));
        EXPECT_GE(row[5], 5);       // busy_cpu_ms
        EXPECT_LT(row[3], row[5]);  // idle_cpu_ms: an empty stage takes less than a full one
        EXPECT_LE(row[3] + row[5], row[1]);  // no stage is longer than its frame
    }
}

TEST(Timer, FrameTimesAddUpToTheRun)
{
    const BusyRun& run = the_busy_run();
    double sum = 0;
    for (const std::vector<double>& row : run.rows) sum += row[1];
    // The clock here stops before the last swap, so frames may only be longer; a hundredth is what
    // the contract allows for what happens between the two clocks.
    EXPECT_GE(sum, 0.99 * run.wall_ms);
}

TEST(Timer, TimestampsThatBeganAnewInBetween)
{
    EXPECT_EQ(nanoseconds_between(5, 12, 64), 7u);
    EXPECT_EQ(nanoseconds_between((1ull << 36) - 5, 2, 36), 7u);
    EXPECT_EQ(nanoseconds_between(~0ull - 4, 2, 64), 7u);
    EXPECT_EQ(nanoseconds_between(5, 12, 0), 7u) << "a driver that does not tell";
}

TEST(Timer, StagesDoNotNest)
{
    EXPECT_TRUE(the_busy_run().refuses_nesting);
}
