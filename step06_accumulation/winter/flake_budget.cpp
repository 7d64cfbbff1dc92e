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

LiveFlakes::LiveFlakes(unsigned particles, float share) : particles_(particles)
{
    // In double precision: in single, beyond 2^24 flakes, one more than there are might live.
    const auto live = [share](unsigned flakes) {
        return GLsizei(std::min(std::ceil(double(share) * flakes), double(flakes)));
    };
    const unsigned half = particles / 2;
    halves_ = {{{0, live(half)}, {GLint(half), live(particles - half)}}};
}

float LiveFlakes::weight() const
{
    const int live = halves_[0].count + halves_[1].count;
    return float(std::max(1u, particles_)) / float(std::max(1, live));
}

void LiveFlakes::set(Program& program) const
{
    program.set("live_of_first", unsigned(halves_[0].count));
    program.set("live_of_second", unsigned(halves_[1].count));
}

void LiveFlakes::draw() const
{
    for (const Range& half : halves_) glDrawArrays(GL_POINTS, half.first, half.count);
}
