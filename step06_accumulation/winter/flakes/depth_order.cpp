#include "step06_accumulation/winter/flakes/depth_order.hpp"

#include <algorithm>
#include <bit>

DepthOrder::DepthOrder(unsigned particles)
    : measure_({{GL_COMPUTE_SHADER, "step06_accumulation/winter/flakes/distances.comp"}}),
      exchange_({{GL_COMPUTE_SHADER, "step06_accumulation/winter/flakes/back_to_front.comp"}}),
      distances_(make_buffer()), order_(make_buffer()),
      size_(std::max(2u, std::bit_ceil(particles)))
{
    for (const GLuint buffer : {GLuint(distances_), GLuint(order_)}) {
        glBindBuffer(GL_SHADER_STORAGE_BUFFER, buffer);
        glBufferData(GL_SHADER_STORAGE_BUFFER, GLsizeiptr(size_ * sizeof(GLuint)), nullptr,
                     GL_DYNAMIC_COPY);
    }
    check_memory("the order of the flakes", 2.0 * sizeof(GLuint) * size_);
}

void DepthOrder::sort(const ParticleBuffer& particles, const LiveFlakes& live)
{
    count_ = live.count[0] + live.count[1];
    // Where no flake is measured, there is one behind the eye, and comes last.
    const GLfloat behind = -1;
    glMemoryBarrier(GL_BUFFER_UPDATE_BARRIER_BIT);
    glBindBuffer(GL_SHADER_STORAGE_BUFFER, distances_);
    glClearBufferData(GL_SHADER_STORAGE_BUFFER, GL_R32F, GL_RED, GL_FLOAT, &behind);
    glBindBufferBase(GL_SHADER_STORAGE_BUFFER, DISTANCES_BUFFER, distances_);
    glBindBufferBase(GL_SHADER_STORAGE_BUFFER, ORDER_BUFFER, order_);
    measure_.use();
    live.set(measure_);
    glMemoryBarrier(GL_SHADER_STORAGE_BARRIER_BIT);  // the draw before has read the order
    particles.dispatch(measure_);
    exchange_.use();
    for (GLuint run = 2; run <= size_; run *= 2) {
        exchange_.set("run", run);
        for (GLuint apart = run / 2; apart > 0; apart /= 2) {
            exchange_.set("apart", apart);
            glMemoryBarrier(GL_SHADER_STORAGE_BARRIER_BIT);      // the pass before has exchanged
            glDispatchCompute((size_ / 2 + 1023) / 1024, 1, 1);  // 1024: local_size_x
        }
    }
    glMemoryBarrier(GL_ELEMENT_ARRAY_BARRIER_BIT);  // a draw takes the order for its indices
}

void DepthOrder::draw() const
{
    glBindBuffer(GL_ELEMENT_ARRAY_BUFFER, order_);
    glDrawElements(GL_POINTS, count_, GL_UNSIGNED_INT, nullptr);
}
