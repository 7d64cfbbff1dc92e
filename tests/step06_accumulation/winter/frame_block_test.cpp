// What the shaders of the winter are told of the frame, in a real window.
#include "step06_accumulation/winter/frame_block.hpp"

#include <gtest/gtest.h>

#include "tests/common/harness/small_window.hpp"

// Where the screen is faster than the snow, a frame makes no step: its flakes are those of the
// frame before, and so are their streaks.
TEST(FrameBlock, KeepsTheShutterInAFrameWithoutAStep)
{
    CommandLine command = small_window(4.3);
    command.lesson.has_scene = true;
    command.scene = "none";
    command.voxels = 32;
    command.frames = 2;
    Window window(command);
    const SolidScene solid(window);
    FrameBlock block(solid);
    std::vector<float> shutters;
    while (window.begin_frame()) {
        if (shutters.empty()) window.next_tick();
        shutters.push_back(block.update(window, Settings{}, 1).shutter);
        window.swap_buffers();
    }
    EXPECT_EQ(shutters, std::vector<float>(2, command.weather.time_step));
}
