#include "step05_collision/ledger.hpp"

#include <iostream>

#include "common/bindings.glsl"

namespace {

struct Counts {  // as ledger.glsl has them: little-endian, the low word first
    GLuint64 released, deposited, melted, left_world;
};

}  // namespace

Ledger::Ledger() : buffer_(make_buffer())
{
    const Counts zero{};
    glBindBuffer(GL_ATOMIC_COUNTER_BUFFER, buffer_);
    glBufferData(GL_ATOMIC_COUNTER_BUFFER, sizeof zero, &zero, GL_DYNAMIC_COPY);
}

void Ledger::bind() const
{
    glBindBufferBase(GL_ATOMIC_COUNTER_BUFFER, LEDGER_BUFFER, buffer_);
}

void Ledger::print(const std::vector<snow::Particle>& flakes) const
{
    Counts counts{};
    glMemoryBarrier(GL_BUFFER_UPDATE_BARRIER_BIT);
    glBindBuffer(GL_ATOMIC_COUNTER_BUFFER, buffer_);
    glGetBufferSubData(GL_ATOMIC_COUNTER_BUFFER, 0, sizeof counts, &counts);
    check_read_back("the ledger");
    size_t airborne_flakes = 0, lying_flakes = 0;
    for (const snow::Particle& flake : flakes) {
        if (flake.age >= 0) ++(flake.rest > 0 ? lying_flakes : airborne_flakes);
    }
    std::cout << "ledger: released " << counts.released << " = airborne " << airborne_flakes
              << " + lying " << lying_flakes << " + deposited " << counts.deposited << " + melted "
              << counts.melted << " + left " << counts.left_world << std::endl;
}
