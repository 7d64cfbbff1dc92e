// The times of frames and stages, in a real window, and what they come to.
#include "common/harness/timing.hpp"

#include <gtest/gtest.h>

#include <fstream>
#include <numeric>
#include <sstream>
#include <stdexcept>
#include <thread>

#include "common/files.hpp"
#include "common/gl_object.hpp"
#include "tests/common/harness/small_window.hpp"

namespace {

using Clock = std::chrono::steady_clock;

// Ten frames of 5 ms, timed to a file, after half a second in which nothing is drawn.
struct BusyRun {
    BusyRun()
    {
        CommandLine command = small_window(1.5);
        command.frames = 10;
        command.csv = std::filesystem::path(testing::TempDir()) / "busy.csv";
        Harness window(command);
        glEnable(GL_DEPTH_BUFFER_BIT);  // which is nothing to enable
        try {
            check_memory("a test", 0);
        } catch (const std::runtime_error& failure) {
            said = failure.what();
        }
        std::this_thread::sleep_for(std::chrono::milliseconds(500));
        const Clock::time_point begin = Clock::now();
        Clock::time_point end;
        while (window.begin_frame()) {
            {
                const auto stage = window.stage("idle");
            }
            {
                const auto stage = window.stage("busy");
                std::this_thread::sleep_for(std::chrono::milliseconds(5));
            }
            end = Clock::now();
            window.swap_buffers();
        }
        wall_ms = std::chrono::duration<double, std::milli>(end - begin).count();
        std::istringstream lines(read_file(command.csv));
        std::getline(lines, header);
        for (std::string line; std::getline(lines, line);) {
            // Behind the renderer, which is quoted because it has commas.
            std::istringstream fields(line.substr(line.rfind('"') + 2));
            std::vector<double> row;
            for (std::string field; std::getline(fields, field, ',');)
                row.push_back(field.empty() || field == "query" ? -1 : std::stod(field));
            rows.push_back(row);
        }
    }

    std::string said, header;
    // frame, frame_ms, timing, then cpu and gpu of each stage
    std::vector<std::vector<double>> rows;
    double wall_ms = 0;
};

// Made once: Mesa may end a program with an X error that opens a second window.
const BusyRun& the_busy_run()
{
    static const BusyRun run;
    return run;
}

}  // namespace

TEST(Timing, FindsTheBusyStage)
{
    const BusyRun& run = the_busy_run();
    EXPECT_EQ(run.header, "step,variant,particles,width,height,renderer,frame,frame_ms,timing,"
                          "idle_cpu_ms,idle_gpu_ms,busy_cpu_ms,busy_gpu_ms");
    ASSERT_EQ(run.rows.size(), 10u);
    for (size_t i = 0; i < run.rows.size(); ++i) {
        const std::vector<double>& row = run.rows[i];
        EXPECT_EQ(row[0], double(i));
        EXPECT_GE(row[5], 5);                // busy_cpu_ms
        EXPECT_LT(row[3], row[5]);           // idle_cpu_ms
        EXPECT_LE(row[3] + row[5], row[1]);  // no stage is longer than its frame
    }
}

TEST(Timing, FrameTimesAddUpToTheLoop)
{
    const BusyRun& run = the_busy_run();
    double sum = 0;
    for (const std::vector<double>& row : run.rows) sum += row[1];
    EXPECT_GE(sum, 0.99 * run.wall_ms);  // the clock here stops before the last swap
    EXPECT_LT(run.rows[0][1], 500) << "what is loaded before the first frame is none of its time";
}

TEST(CheckMemory, SaysOtherErrorsToo)
{
    EXPECT_EQ(the_busy_run().said, "a test: OpenGL error 0x0500");
}

TEST(Timing, ARendererMayHaveQuotes)
{
    const std::string csv =
        csv_of({{1, false, {}}}, small_window(1.5), {64, 64}, "a \"card\", fast");
    EXPECT_NE(csv.find(",64,64,\"a \"\"card\"\", fast\",0,"), std::string::npos) << csv;
}

TEST(Timing, QuantilesAreRanks)
{
    EXPECT_EQ(quantile({}, 0.5), 0);
    EXPECT_EQ(quantile({3, 1, 2}, 0.5), 2);
    std::vector<double> hundred(100);
    std::iota(hundred.begin(), hundred.end(), 0);
    EXPECT_EQ(quantile(hundred, 0.95), 95);
    EXPECT_EQ(quantile(hundred, 1), 99);
}
