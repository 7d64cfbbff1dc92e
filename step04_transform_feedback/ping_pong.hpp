// The two buffers of step 4's main.cpp, which change roles with every update, and the two vertex
// arrays that read them.
#pragma once

#include <GL/glew.h>

#include <utility>
#include <vector>

#include "common/gl_object.hpp"
#include "step03_shader_points/particle_layout.hpp"

class PingPong {
public:
    explicit PingPong(const std::vector<snow::Particle>& flakes)
        : bytes_(GLsizeiptr(flakes.size() * sizeof(snow::Particle)))
    {
        for (Half* half : {&now_, &next_}) {
            glBindVertexArray(half->vao);
            glBindBuffer(GL_ARRAY_BUFFER, half->buffer);
            glBufferData(GL_ARRAY_BUFFER, bytes_, flakes.data(), GL_DYNAMIC_COPY);
            check_memory("the flakes", double(bytes_));
            describe_particles();
        }
    }

    GLuint vao() const { return now_.vao; }         // reads the flakes as they are
    GLuint buffer() const { return now_.buffer; }   // where those are
    GLuint target() const { return next_.buffer; }  // where an update is to write them
    void swap() { std::swap(now_, next_); }         // what was written is what is read from now on

    // Reads all flakes back: for the dump, never within a frame.
    void read(std::vector<snow::Particle>& flakes) const
    {
        glBindBuffer(GL_ARRAY_BUFFER, now_.buffer);
        glGetBufferSubData(GL_ARRAY_BUFFER, 0, bytes_, flakes.data());
        check_read_back("the flakes");
    }

private:
    struct Half {
        GlObject buffer = make_buffer(), vao = make_vertex_array();
    };
    GLsizeiptr bytes_;
    Half now_, next_;
};
