#include "step06_accumulation/winter/budget/flake_budget.hpp"

#include <algorithm>
#include <cmath>
#include <iostream>

std::vector<snow::Parameter> FlakeBudget::parameters()
{
    return {
        {"hold_fps", "hold", "fps", 0, 240, "frame rate to hold by moving fewer flakes; 0: none",
         &hold_fps},
        {"live", "part that moves", "", 0.01f, 1,
         "part of the flakes that moves at most, each the heavier", &live},
    };
}

void FlakeBudget::frame(double seconds, int ticks, float fps, float maximum)
{
    if (fps <= 0) *this = {};
    maximum_ = maximum;
    longest_ = std::max(longest_, seconds);
    seconds_ += seconds;
    ticks_ += ticks;
    if (++frames_ < 5 || seconds_ < 0.4 || fps <= 0) return;
    // Without the longest, which may have been a hitch.
    const float slowness = float((seconds_ - longest_) / (frames_ - 1)) * fps;
    const bool paused = ticks_ == 0;
    seconds_ = longest_ = 0;
    frames_ = ticks_ = 0;
    if (!paused) decide(slowness);
    share_ = std::clamp(share_, 0.01f, 1.0f);
    if (share_ > 0.75f * told_ && told_ > 0.75f * share_) return;
    told_ = share_;
    std::cout << "holding " << fps << " fps: " << report() << std::endl;
}

float FlakeBudget::share() const
{
    return std::min(share_, maximum_);
}

std::string FlakeBudget::report() const
{
    return std::to_string(int(std::lround(100 * share()))) + " % of the flakes live";
}

void FlakeBudget::decide(float slowness)
{
    if (slowness > 1.1f) {
        share_ = share() * std::max(0.6f, 1 / std::sqrt(slowness));
        if (growing_) patience_ = std::min(2 * patience_, 32);
        growing_ = false;
        waited_ = 0;
    } else if (slowness < 0.9f && ++waited_ >= patience_) {
        share_ = share() * std::min(1.2f, std::pow(slowness, -0.2f));
        growing_ = true;
    } else if (growing_) {  // it has reached the band
        patience_ = std::max(patience_ / 2, 1);
        growing_ = false;
    }
}
