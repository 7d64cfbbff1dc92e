// The times of frames and stages, in a real window, and what they come to.
#include "common/harness/timing.hpp"

#include <gtest/gtest.h>

#include <cstdio>
#include <sstream>
#include <stdexcept>
#include <thread>

#include "common/files.hpp"
#include "common/gl_object.hpp"
#include "tests/common/harness/small_window.hpp"

// Ten frames of 5 ms, timed to a file, after half a second in which nothing is drawn.
TEST(Timing, FindsTheBusyStageAndAddsUpToTheLoop)
{
    using Clock = std::chrono::steady_clock;
    CommandLine command = small_window(1.5);
    command.frames = 10;
    command.csv = std::filesystem::path(testing::TempDir()) / "busy.csv";
    Clock::time_point begin, end;
    {
        Harness window(command);
        glEnable(GL_DEPTH_BUFFER_BIT);  // which is nothing to enable
        try {
            check_memory("a test", 0);
            ADD_FAILURE() << "an error of OpenGL goes unseen";
        } catch (const std::runtime_error& failure) {
            EXPECT_EQ(failure.what(), std::string("a test: OpenGL error 0x0500"));
        }
        std::this_thread::sleep_for(std::chrono::milliseconds(500));
        begin = Clock::now();
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
    }
    std::istringstream lines(read_file(command.csv));
    std::string line;
    std::getline(lines, line);
    EXPECT_EQ(line, "step,variant,particles,width,height,renderer,frame,frame_ms,timing,"
                    "idle_cpu_ms,idle_gpu_ms,busy_cpu_ms,busy_gpu_ms");
    double sum = 0;
    int rows = 0;
    for (; std::getline(lines, line); ++rows) {
        // Behind the renderer, which is quoted because it has commas.
        line = line.substr(line.rfind('"') + 2);
        int frame = 0;
        double frame_ms = 0, idle_ms = 0, busy_ms = 0;
        std::sscanf(line.c_str(), "%d,%lf,query,%lf,%*[^,],%lf", &frame, &frame_ms, &idle_ms,
                    &busy_ms);
        EXPECT_EQ(frame, rows) << line;
        EXPECT_GE(busy_ms, 5);
        EXPECT_LT(idle_ms, busy_ms);
        EXPECT_LE(idle_ms + busy_ms, frame_ms);  // no stage is longer than its frame
        EXPECT_LT(frame_ms, 500) << "what came before is none of its time";
        sum += frame_ms;
    }
    EXPECT_EQ(rows, 10);
    // The clock here stops before the last swap.
    const std::chrono::duration<double, std::milli> loop = end - begin;
    EXPECT_GE(sum, 0.99 * loop.count());
}

TEST(Timing, ARendererMayHaveQuotes)
{
    const std::string csv =
        csv_of({{1, false, {}}}, small_window(1.5), {64, 64}, "a \"card\", fast");
    EXPECT_NE(csv.find(",64,64,\"a \"\"card\"\", fast\",0,"), std::string::npos) << csv;
}
