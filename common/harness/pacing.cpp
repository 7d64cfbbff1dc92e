#include "common/harness/pacing.hpp"

#include <algorithm>
#include <utility>

unsigned frames_in_one(const CommandLine& command, uint64_t drawn)
{
    constexpr unsigned many = 60;
    return command.reproducible() && drawn + 2 * many <= command.warmup ? many : 1;
}

int Pacing::begin_frame(const CommandLine& command, double seconds, unsigned frames,
                        Controls& controls)
{
    const double time_step = command.weather.time_step, timelapse = command.timelapse;
    constexpr int maximum = 8;
    begin_ = std::chrono::steady_clock::now();
    made_ = 0;
    by_the_clock_ = !command.reproducible();
    owed_ = std::min(owed_ + timelapse * seconds, maximum * timelapse * time_step);
    if (controls.paused) {
        owed_ = 0;
        due_ = std::exchange(controls.single_step, false) ? 1 : 0;
    } else if (by_the_clock_) {
        due_ = int(owed_ / time_step);
        owed_ -= due_ * time_step;
    } else {
        due_ = int(command.timelapse * frames);
    }
    return due_;
}

bool Pacing::next_tick()
{
    const bool late = by_the_clock_ && made_ > 0 &&
                      std::chrono::steady_clock::now() - begin_ > std::chrono::milliseconds(50);
    if (made_ >= due_ || late) return false;
    ++made_;
    return true;
}
