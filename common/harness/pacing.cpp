#include "common/harness/pacing.hpp"

#include <algorithm>
#include <utility>

int Pacing::ticks(const CommandLine& command, double seconds, Controls& controls)
{
    const double time_step = command.weather.time_step, timelapse = command.timelapse;
    constexpr int maximum = 8;
    owed_ = std::min(owed_ + timelapse * seconds, maximum * timelapse * time_step);
    if (controls.paused) {
        owed_ = 0;
        return std::exchange(controls.single_step, false) ? 1 : 0;
    }
    if (command.reproducible()) return int(command.timelapse);
    const int due = int(owed_ / time_step);
    owed_ -= due * time_step;
    return due;
}
