// What the shaders of the winter are told of the frame, in a real window.
#include "step06_accumulation/winter/frame_block.hpp"

#include <gtest/gtest.h>

#include "tests/common/harness/small_window.hpp"

namespace {

CommandLine empty_scene()
{
    CommandLine command = small_window(4.3);
    command.lesson.has_scene = true;
    command.scene = "none";
    command.voxels = 32;
    command.frames = 2;
    return command;
}

}  // namespace

// Where the screen is faster than the snow, a frame makes no step: its flakes are those of the
// frame before, and so are their streaks.
TEST(FrameBlock, KeepsTheShutterInAFrameWithoutAStep)
{
    Harness window(empty_scene());
    const SolidScene solid(window);
    FrameBlock block(solid);
    std::vector<float> shutters;
    while (window.begin_frame()) {
        if (shutters.empty()) window.next_tick();
        shutters.push_back(block.update(window, Settings{}, 1).shutter);
        window.swap_buffers();
    }
    EXPECT_EQ(shutters, std::vector<float>(2, window.options().weather.time_step));

    // The field keeps its snow when it stops snowing, and loses as much to a thaw as the cover.
    auto& weather = const_cast<snow::Weather&>(window.options().weather);  // as a slider does
    FrameBlock field(solid);
    const auto depth_after = [&](unsigned minutes) {
        return field.update(window, Settings{}, minutes * 3600).field_depth;
    };
    const float snow = depth_after(10);
    EXPECT_GT(snow, 9 * weather.snowfall);
    weather.snowfall = 0;
    EXPECT_EQ(depth_after(11), snow);
    weather.temperature = 5;
    EXPECT_NEAR(depth_after(12), snow - 0.05f, 1e-5f);  // melt.comp: 1 cm a minute and degree
}
