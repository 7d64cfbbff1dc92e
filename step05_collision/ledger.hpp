// Where every flake that was ever released has gone, counted on the GPU and read once, at the end.
#pragma once

#include <GL/glew.h>

#include <iostream>
#include <vector>

#include "common/gl_object.hpp"
#include "common/snow.hpp"

class Ledger {
public:
    Ledger() : buffer_(make_buffer())
    {
        const Counts zero{};
        glBindBuffer(GL_ATOMIC_COUNTER_BUFFER, buffer_);
        glBufferData(GL_ATOMIC_COUNTER_BUFFER, sizeof zero, &zero, GL_DYNAMIC_COPY);
        glBindBufferBase(GL_ATOMIC_COUNTER_BUFFER, 0, buffer_);
    }

    // Prints the line in which released = airborne + lying + deposited + melted + left. Returns the
    // number of flakes deposited.
    GLuint print(const std::vector<snow::Particle>& flakes) const
    {
        Counts counts{};
        glMemoryBarrier(GL_BUFFER_UPDATE_BARRIER_BIT);
        glBindBuffer(GL_ATOMIC_COUNTER_BUFFER, buffer_);
        glGetBufferSubData(GL_ATOMIC_COUNTER_BUFFER, 0, sizeof counts, &counts);
        size_t airborne_flakes = 0, lying_flakes = 0;
        for (const snow::Particle& flake : flakes) {
            if (flake.age >= 0) ++(flake.rest > 0 ? lying_flakes : airborne_flakes);
        }
        std::cout << "ledger: released " << counts.released << " = airborne " << airborne_flakes
                  << " + lying " << lying_flakes << " + deposited " << counts.deposited
                  << " + melted " << counts.melted << " + left " << counts.left_world << std::endl;
        return counts.deposited;
    }

private:
    struct Counts {
        GLuint released, deposited, melted, left_world;
    };
    GlObject buffer_;
};
