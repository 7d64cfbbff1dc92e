#include "step06_accumulation/winter/flakes/depth_order.hpp"

#include <algorithm>
#include <bit>

namespace {

void dispatch(GLuint invocations)
{
    glDispatchCompute((invocations + 1023) / 1024, 1, 1);  // 1024: local_size_x
    glMemoryBarrier(GL_SHADER_STORAGE_BARRIER_BIT);
}

}  // namespace

DepthOrder::DepthOrder()
    : measure_({{GL_COMPUTE_SHADER, "step06_accumulation/winter/flakes/distances.comp"}}),
      exchange_({{GL_COMPUTE_SHADER, "step06_accumulation/winter/flakes/back_to_front.comp"}}),
      distances_(make_buffer()), order_(make_buffer())
{}

void DepthOrder::sort(const PingPong& particles, const LiveFlakes& live)
{
    count_ = 0;
    for (const Range& half : live) count_ += half.count;
    const GLuint places = std::max(2u, std::bit_ceil(GLuint(count_)));
    if (places != places_) {
        places_ = places;
        for (const GLuint buffer : {GLuint(distances_), GLuint(order_)}) {
            glBindBuffer(GL_SHADER_STORAGE_BUFFER, buffer);
            glBufferData(GL_SHADER_STORAGE_BUFFER, GLsizeiptr(places * sizeof(GLuint)), nullptr,
                         GL_DYNAMIC_COPY);
        }
        check_memory("the order of the flakes", 2.0 * sizeof(GLuint) * places);
    }
    glBindBufferBase(GL_SHADER_STORAGE_BUFFER, FLAKES_BUFFER, particles.buffer());
    glBindBufferBase(GL_SHADER_STORAGE_BUFFER, DISTANCES_BUFFER, distances_);
    glBindBufferBase(GL_SHADER_STORAGE_BUFFER, ORDER_BUFFER, order_);
    measure_.use();
    GLuint place = 0;
    const auto measure = [&](GLuint first, GLuint count, GLuint to_write) {
        if (to_write == 0) return;
        measure_.set("first", first);
        measure_.set("count", count);
        measure_.set("place", place);
        measure_.set("places", to_write);
        dispatch(to_write);
        place += to_write;
    };
    for (const Range& half : live)
        measure(GLuint(half.first), GLuint(half.count), GLuint(half.count));
    measure(0, 0, places - place);
    exchange_.use();
    for (GLuint run = 2; run <= places; run *= 2) {
        exchange_.set("run", run);
        for (GLuint apart = run / 2; apart > 0; apart /= 2) {
            exchange_.set("apart", apart);
            dispatch(places / 2);
        }
    }
    glMemoryBarrier(GL_ELEMENT_ARRAY_BARRIER_BIT);  // a draw takes the order for its indices
}

void DepthOrder::draw() const
{
    glBindBuffer(GL_ELEMENT_ARRAY_BUFFER, order_);
    glDrawElements(GL_POINTS, count_, GL_UNSIGNED_INT, nullptr);
}
