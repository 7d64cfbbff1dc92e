#include "step06_accumulation/winter/flake_budget.hpp"

#include <algorithm>
#include <cmath>
#include <iostream>

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
    if (paused) return;
    // Fewer at once; more with care: never across the band, not even where frames grow with the
    // fifth power of the share, as they do when long frames have more steps to make.
    if (slowness > 1.1f) share_ = share() * std::max(0.6f, 1 / std::sqrt(slowness));
    if (slowness < 0.9f) share_ = share() * std::min(1.2f, std::pow(slowness, -0.2f));
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

LiveFlakes::LiveFlakes(unsigned all, float share) : particles(all), first{0, GLint(all / 2)}
{
    // In double precision: in single, beyond 2^24 flakes, one more than there are might live.
    const auto live = [share](unsigned flakes) {
        return GLsizei(std::min(std::ceil(double(share) * flakes), double(flakes)));
    };
    count[0] = live(all / 2);
    count[1] = live(all - all / 2);
}

float LiveFlakes::weight() const
{
    return float(std::max(1u, particles)) / float(std::max(1, count[0] + count[1]));
}

void LiveFlakes::set(Program& program) const
{
    program.set("live_of_first", unsigned(count[0]));
    program.set("live_of_second", unsigned(count[1]));
}

void LiveFlakes::draw() const
{
    glMultiDrawArrays(GL_POINTS, first, count, 2);
}

void LiveFlakes::draw_around() const
{
    for (const int emitter : {0, 1})
        glDrawArraysInstanced(GL_POINTS, first[emitter], count[emitter] / 8, 8);
}
