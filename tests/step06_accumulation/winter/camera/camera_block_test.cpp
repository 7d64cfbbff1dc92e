// What the shaders of the winter are told of the camera, in a real window.
#include "step06_accumulation/winter/camera/camera_block.hpp"

#include <gtest/gtest.h>

#include "tests/common/harness/small_window.hpp"

// Where the screen is faster than the snow, a frame makes no step: its flakes are those of the
// frame before, and so are their streaks.
TEST(CameraBlock, KeepsTheShutterInAFrameWithoutAStep)
{
    CommandLine command = small_window(3.3);
    command.frames = 2;
    Window window(command);
    CameraBlock block;
    std::vector<float> shutters;
    while (window.begin_frame()) {
        if (shutters.empty()) window.next_tick();
        block.update(window, 1);
        snow::CameraView view{};
        glGetBufferSubData(GL_UNIFORM_BUFFER, 0, sizeof view, &view);
        shutters.push_back(view.shutter);
        window.swap_buffers();
    }
    EXPECT_EQ(shutters, std::vector<float>(2, command.weather.time_step));
}
