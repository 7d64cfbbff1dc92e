// The variant "soa": same as main.cpp, but the flakes are no array of structs: they are a struct of
// arrays. All positions lie in one of them, and no more than that is uploaded: 12 bytes a flake,
// not 32. In return the update has to gather each flake from four arrays, and to scatter it again.

#include <GL/glew.h>

#include <glm/gtc/type_ptr.hpp>

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

    explicit Flakes(const std::vector<Particle>& flakes)
        : positions(flakes.size()), velocities(flakes.size()), ages(flakes.size()),
          rests(flakes.size())
    {
        scatter(flakes, 0);
    }

    // Writes these flakes to their indices, `first` and the next.
    void scatter(std::span<const Particle> flakes, size_t first)
    {
        for (size_t i = 0; i < flakes.size(); ++i) {
            positions[first + i] = flakes[i].position;
            ages[first + i] = flakes[i].age;
            velocities[first + i] = flakes[i].velocity;
            rests[first + i] = flakes[i].rest;
        }
    }

    // The flakes of that many indices, `first` and the next.
    std::vector<Particle> gather(size_t first, size_t count) const
    {
        std::vector<Particle> flakes;
        flakes.reserve(count);
        for (size_t i = first; i < first + count; ++i)
            flakes.push_back({positions[i], ages[i], velocities[i], rests[i]});
        return flakes;
    }

    // The loop of update_in_one_loop; the physics wants each flake in one piece.
    void update(uint tick, const Weather& weather)
    {
        for (size_t begin = 0; begin < positions.size(); begin += block) {
            std::vector<Particle> some = gather(begin, min(block, positions.size() - begin));
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

    Flakes flakes(make_flakes(weather));
    uint tick = 0;                                           // time steps made so far
    const std::vector<Group> groups = make_groups(options);  // flakes of one size
    const GLsizeiptr bytes = GLsizeiptr(flakes.positions.size() * sizeof(vec3));
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
    window.dump(flakes.gather(0, flakes.positions.size()));
}
