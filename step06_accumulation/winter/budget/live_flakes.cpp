#include "step06_accumulation/winter/budget/live_flakes.hpp"

#include <algorithm>
#include <cmath>

LiveFlakes::LiveFlakes(unsigned particles) : particles_(int(particles))
{
    set(1);
}

void LiveFlakes::resize(float share, const PingPong& particles)
{
    const std::array<Range, 2> before = halves_;
    set(share);
    for (int i = 0; i < 2; ++i) {
        const GLintptr resting = begin_of(halves_[i]) + size_of(halves_[i]);
        const GLintptr end = begin_of(before[i]) + size_of(before[i]);
        if (resting >= end) continue;
        glBindBuffer(GL_COPY_READ_BUFFER, particles.buffer());
        glBindBuffer(GL_COPY_WRITE_BUFFER, particles.target());
        glCopyBufferSubData(GL_COPY_READ_BUFFER, GL_COPY_WRITE_BUFFER, resting, resting,
                            end - resting);
    }
}

float LiveFlakes::weight() const
{
    return float(std::max(1, particles_)) / float(std::max(1, halves_[0].count + halves_[1].count));
}

void LiveFlakes::set(float share)
{
    const int half = particles_ / 2, rest = particles_ - half;
    halves_ = {
        {{0, int(std::ceil(share * float(half)))}, {half, int(std::ceil(share * float(rest)))}}};
}
