// The variant "soa": same as main.cpp, but the flakes are no array of structs: they are a struct of
// arrays. All positions lie in one of them, and no more than that is uploaded: 12 bytes a flake,
// not 32. In return the update has to gather each flake from four places, and to scatter it again.

#include <GL/glew.h>

#include <array>
#include <glm/gtc/type_ptr.hpp>

#include "common/gl_object.hpp"
#include "common/window.hpp"
#include "step01_cpu_points/ground.hpp"
#include "step01_cpu_points/update.hpp"
#include "step02_vbo/usage.hpp"

using namespace snow;

namespace {

// All flakes, a quantity at a time.
struct Flakes {
    std::vector<vec3> positions, velocities;
    std::vector<float> ages, rests;

    explicit Flakes(const std::vector<Particle>& flakes)
        : positions(flakes.size()), velocities(flakes.size()), ages(flakes.size()),
          rests(flakes.size())
    {
        scatter(flakes, 0);
    }

    // Writes these flakes, of which the first has the index `first`, to where they belong.
    void scatter(std::span<const Particle> flakes, size_t first)
    {
        for (size_t i = 0; i < flakes.size(); ++i) {
            positions[first + i] = flakes[i].position;
            ages[first + i] = flakes[i].age;
            velocities[first + i] = flakes[i].velocity;
            rests[first + i] = flakes[i].rest;
        }
    }

    // Reads as many as there is room for, from index `first` on.
    void gather(std::span<Particle> flakes, size_t first) const
    {
        for (size_t i = 0; i < flakes.size(); ++i) {
            flakes[i] = {positions[first + i], ages[first + i], velocities[first + i],
                         rests[first + i]};
        }
    }

    std::vector<Particle> gather() const
    {
        std::vector<Particle> flakes(positions.size());
        gather(flakes, 0);
        return flakes;
    }

    // The loop of update_in_one_loop; the physics wants each flake in one piece.
    void update(uint tick, const Weather& weather)
    {
        std::array<Particle, block> room;
        for (size_t begin = 0; begin < positions.size(); begin += block) {
            const std::span<Particle> some(room.data(), min(block, positions.size() - begin));
            gather(some, begin);
            update_block(some, uint(begin), tick, weather);
            scatter(some, begin);
        }
    }
};

}  // namespace

void run_soa(Window& window)
{
    const Options& options = window.options();
    const Weather& weather = options.weather;
    const GLenum hint = usage(options.hint);

    Flakes flakes(make_flakes(weather));
    uint tick = 0;  // time steps made so far
    const GLsizeiptr bytes = GLsizeiptr(flakes.positions.size() * sizeof(vec3));
    const GlObject buffer = make_buffer();
    glBindBuffer(GL_ARRAY_BUFFER, buffer);
    glBufferData(GL_ARRAY_BUFFER, bytes, nullptr, hint);
    check_memory("the positions", double(bytes));

    glClearColor(0.05f, 0.10f, 0.10f, 1.0f);
    while (window.begin_frame()) {
        glViewport(0, 0, window.size().x, window.size().y);
        glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
        draw_ground(window);
        {
            const auto stage = window.stage("update");
            while (window.next_tick()) flakes.update(tick++, weather);
        }
        {
            const auto stage = window.stage("upload");
            glBindBuffer(GL_ARRAY_BUFFER, buffer);
            // The draw of the frame before may still be reading: the driver copies, or waits.
            glBufferSubData(GL_ARRAY_BUFFER, 0, bytes, flakes.positions.data());
        }
        {
            const auto stage = window.stage("draw");
            glMatrixMode(GL_PROJECTION);
            glLoadMatrixf(value_ptr(window.projection()));
            glMatrixMode(GL_MODELVIEW);
            glLoadMatrixf(value_ptr(window.view()));
            // Positions lie one right behind the other in the buffer that is bound.
            glEnableClientState(GL_VERTEX_ARRAY);
            glVertexPointer(3, GL_FLOAT, sizeof(vec3), nullptr);
            // In pieces, for points of two sizes: the first half of the pool is emitter 0's, of
            // small flakes, the second half emitter 1's.
            for (uint group = 0; group < options.groups; ++group) {
                const uint begin = options.group_begin(group), end = options.group_begin(group + 1);
                glPointSize(options.point_size * (of_first_emitter(begin, weather) ? 1.0f : 2.0f));
                glDrawArrays(GL_POINTS, GLint(begin), GLsizei(end - begin));
            }
        }
        window.swap_buffers();
    }
    window.dump(flakes.gather());
}
