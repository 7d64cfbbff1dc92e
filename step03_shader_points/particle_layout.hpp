// How a vertex shader finds the fields of a Particle in a buffer: attribute locations 0 to 3 are
// position, age, velocity and rest in all shaders of the series.
#pragma once

#include <GL/glew.h>

#include "common/snow.hpp"

// Points the four attributes of the bound vertex array at the buffer bound to GL_ARRAY_BUFFER.
// stride: bytes from one Particle there to the next.
inline void describe_particles(GLsizei stride = sizeof(snow::Particle))
{
    const auto field = [stride](GLuint location, GLint floats, size_t offset) {
        glEnableVertexAttribArray(location);
        glVertexAttribPointer(location, floats, GL_FLOAT, GL_FALSE, stride,
                              reinterpret_cast<const void*>(offset));
    };
    field(0, 3, offsetof(snow::Particle, position));
    field(1, 1, offsetof(snow::Particle, age));
    field(2, 3, offsetof(snow::Particle, velocity));
    field(3, 1, offsetof(snow::Particle, rest));
}
