#include "step06_accumulation/winter/camera/camera_block.hpp"

#include <algorithm>

#include "step06_accumulation/cover/columns.hpp"

void CameraBlock::update(const Window& window, unsigned tick)
{
    const snow::Weather& weather = window.options().weather;
    const bool first = camera_.window_size.x == 0;
    camera_.view_before = first ? window.view() : camera_.view;
    camera_.view = window.view();
    camera_.projection = window.projection();
    camera_.eye = window.eye();
    // Where the screen is faster than the time steps, some frames show the same flakes once more:
    // as before, or streaks and dots would alternate.
    if (window.ticks() > 0) {
        camera_.shutter =
            float(window.ticks()) * weather.time_step / float(window.options().timelapse);
    }
    camera_.window_size = window.size();
    // The first flakes, fewer than there will be, fall and lie for a while before they are part of
    // the cover; and depth.comp lets that appear in some ten rounds.
    const snow::Emitter& cloud = weather.emitters[0];
    const float late = 1.25f * cloud.centre.y / cloud.terminal_speed + weather.melt_time +
                       10 * Columns::turns * weather.time_step;  // s
    camera_.field_depth =
        weather.snowfall / 60.0f * std::max(float(tick) * weather.time_step - late, 0.0f);
    block_.update(CAMERA_BLOCK, camera_);
}
