// The one buffer of step 4's compute.cpp, in which a compute shader moves the flakes, and the
// vertex array that reads them.
#pragma once

#include <GL/glew.h>

#include <algorithm>
#include <vector>

#include "common/gl_object.hpp"
#include "common/program.hpp"
#include "step03_shader_points/particle_layout.hpp"

class ParticleBuffer {
public:
    explicit ParticleBuffer(const std::vector<snow::Particle>& flakes) : count_(flakes.size())
    {
        glBindVertexArray(vao_);
        glBindBuffer(GL_ARRAY_BUFFER, buffer_);
        glBufferData(GL_ARRAY_BUFFER, bytes(count_), flakes.data(), GL_DYNAMIC_COPY);
        check_memory("the flakes", double(bytes(count_)));
        describe_particles();
        // No shader sees more of a buffer at once, and no dispatch has more groups, than a card has
        // to take.
        GLint64 largest = 0;
        glGetInteger64v(GL_MAX_SHADER_STORAGE_BLOCK_SIZE, &largest);
        piece_ = std::min(size_t(largest) / sizeof(snow::Particle) / group * group,
                          size_t(65535) * group);
    }

    GLuint vao() const { return vao_; }

    // Runs a compute shader, `update`, which is in use, for every flake: piece by piece of the
    // buffer, at FLAKES_BUFFER. Its uniform `first` is the index of a piece's first flake.
    void dispatch(Program& update) const
    {
        for (size_t first = 0; first < count_; first += piece_) {
            const size_t count = std::min(piece_, count_ - first);
            glBindBufferRange(GL_SHADER_STORAGE_BUFFER, FLAKES_BUFFER, buffer_,
                              GLintptr(bytes(first)), bytes(count));
            update.set("first", unsigned(first));
            glDispatchCompute(GLuint((count + group - 1) / group), 1, 1);
        }
    }

    // Reads all flakes back: for the dump, never within a frame.
    void read(std::vector<snow::Particle>& flakes) const
    {
        glMemoryBarrier(GL_BUFFER_UPDATE_BARRIER_BIT);
        glBindBuffer(GL_ARRAY_BUFFER, buffer_);
        glGetBufferSubData(GL_ARRAY_BUFFER, 0, bytes(count_), flakes.data());
        check_read_back("the flakes");
    }

private:
    static constexpr size_t group = 128;  // local_size_x of the shaders
    static GLsizeiptr bytes(size_t flakes) { return GLsizeiptr(flakes * sizeof(snow::Particle)); }

    size_t count_, piece_;
    GlObject buffer_ = make_buffer(), vao_ = make_vertex_array();
};
