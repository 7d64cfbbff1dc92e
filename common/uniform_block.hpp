// What a uniform block of the shaders holds: one buffer, whose contents are replaced.
#pragma once

#include "common/bindings.glsl"
#include "common/gl_object.hpp"

// T: a struct that GLSL (std140) and C++ lay out alike.
template <typename T>
class UniformBlock {
public:
    UniformBlock() : buffer_(make_buffer())
    {
        glBindBuffer(GL_UNIFORM_BUFFER, buffer_);
        glBufferData(GL_UNIFORM_BUFFER, sizeof(T), nullptr, GL_DYNAMIC_DRAW);
    }

    // Every program in which the block has this binding point reads from this one from now on.
    void bind(GLuint binding) const { glBindBufferBase(GL_UNIFORM_BUFFER, binding, buffer_); }

    // The same, with new contents.
    void update(GLuint binding, const T& contents)
    {
        bind(binding);
        glBufferSubData(GL_UNIFORM_BUFFER, 0, sizeof contents, &contents);
    }

private:
    GlObject buffer_;
};
