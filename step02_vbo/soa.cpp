// The variant "soa": same as main.cpp, but the flakes are no array of structs: they are a struct of
// arrays. All positions lie in one of them, and no more than that is uploaded: 12 bytes a flake,
// not 32. In return the update has to gather each flake from four arrays, and to scatter it again.

#include <GL/glew.h>

#include "common/gl_object.hpp"
#include "common/window.hpp"
#include "step01_cpu_points/ground.hpp"
#include "step01_cpu_points/groups.hpp"
#include "step01_cpu_points/update.hpp"

using namespace snow;

namespace {

// All flakes, a quantity at a time.
struct Flakes {
    std::vector<vec3> positions, velocities;
    std::vector<float> ages, rests;

    explicit Flakes(size_t size) : positions(size), velocities(size), ages(size), rests(size) {}

    Particle gather(size_t i) const { return {positions[i], ages[i], velocities[i], rests[i]}; }
    void scatter(size_t i, const Particle& flake)
    {
        positions[i] = flake.position;
        ages[i] = flake.age;
        velocities[i] = flake.velocity;
        rests[i] = flake.rest;
    }

    // The loop of update_in_one_loop; the physics wants each flake in one piece.
    void update(uint tick, const Weather& weather)
    {
        Particle some[block];
        for (size_t begin = 0; begin < positions.size(); begin += block) {
            const size_t count = min(block, positions.size() - begin);
            for (size_t i = 0; i < count; ++i) some[i] = gather(begin + i);
            update_block({some, count}, uint(begin), tick, weather);
            for (size_t i = 0; i < count; ++i) scatter(begin + i, some[i]);
        }
    }
};

}  // namespace

void run_soa(Window& window)
{
    const Options& options = window.options();
    const Weather& weather = options.weather;

    std::vector<Particle> flakes = make_flakes(weather);
    Flakes arrays(flakes.size());
    for (size_t i = 0; i < flakes.size(); ++i) arrays.scatter(i, flakes[i]);
    uint tick = 0;                                           // time steps made so far
    const std::vector<Group> groups = make_groups(options);  // flakes of one size
    const GLsizeiptr bytes = GLsizeiptr(flakes.size() * sizeof(vec3));
    const GlObject buffer = make_buffer();
    glBindBuffer(GL_ARRAY_BUFFER, buffer);
    glBufferData(GL_ARRAY_BUFFER, bytes, nullptr, GL_STREAM_DRAW);
    check_memory("the positions", double(bytes));

    glClearColor(0.05f, 0.10f, 0.10f, 1.0f);
    while (window.begin_frame()) {
        glViewport(0, 0, window.size().x, window.size().y);
        glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
        draw_ground(window);
        {
            const auto stage = window.stage("update");
            while (window.next_tick()) arrays.update(tick++, weather);
        }
        {
            const auto stage = window.stage("upload");
            glBindBuffer(GL_ARRAY_BUFFER, buffer);
            // The draw of the frame before may still be reading: the driver copies, or waits.
            glBufferSubData(GL_ARRAY_BUFFER, 0, bytes, arrays.positions.data());
        }
        {
            const auto stage = window.stage("draw");
            load_matrices(window);
            // Positions lie one right behind the other in the buffer that is bound.
            glEnableClientState(GL_VERTEX_ARRAY);
            glVertexPointer(3, GL_FLOAT, sizeof(vec3), nullptr);
            for (const Group& group : groups) {
                glPointSize(group.point_size);
                glDrawArrays(GL_POINTS, GLint(group.begin), GLsizei(group.end - group.begin));
            }
        }
        window.swap_buffers();
    }
    for (size_t i = 0; i < flakes.size(); ++i) flakes[i] = arrays.gather(i);
    window.dump(flakes);
}
