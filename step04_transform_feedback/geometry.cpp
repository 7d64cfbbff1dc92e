// The variant "geometry": same as main.cpp, but the buffer holds only flakes that live, as
// Pettersson and Jin have it: a geometry shader emits each flake that lives on; then those that are
// born are appended. The GPU draws as many as it has written, without telling their number.

#include <GL/glew.h>

#include <algorithm>
#include <stdexcept>

#include "common/program.hpp"
#include "common/uniform_block.hpp"
#include "common/window.hpp"
#include "step01_cpu_points/ground.hpp"
#include "step03_shader_points/particle_layout.hpp"

using namespace snow;

namespace {

// A flake carries its index along: its position among those that live no longer tells.
struct LiveFlake {
    Particle particle;
    uint index;
};
static_assert(sizeof(LiveFlake) == 36, "as transform feedback writes it");

// A flake that waits to be born, after that many time steps: added up as all updates do, with the
// same rounding.
Particle waited(Particle p, uint ticks, const Weather& weather)
{
    for (uint i = 0; i < ticks; ++i) p = move(p, weather);
    return p;
}

}  // namespace

void run_geometry(Window& window)
{
    const Options& options = window.options();
    const Weather& weather = options.weather;
    if (!GLEW_ARB_transform_feedback2) {
        throw std::runtime_error("--variant geometry needs OpenGL 4.0: try feedback");
    }

    std::vector<Particle> flakes = make_flakes(weather);
    uint tick = 0;  // time steps made so far
    // Those that wait for their first birth, in the order in which they are born.
    std::vector<LiveFlake> waiting(flakes.size());
    for (uint i = 0; i < waiting.size(); ++i) waiting[i] = {flakes[i], i};
    std::sort(waiting.begin(), waiting.end(), [](const LiveFlake& a, const LiveFlake& b) {
        return a.particle.age > b.particle.age;
    });
    auto next_born = waiting.begin();
    const GLsizeiptr bytes = GLsizeiptr(waiting.size() * sizeof(LiveFlake));
    // Ping-pong, with room for all in each; and a third for those that wait.
    enum { first, second, unborn_flakes };
    GlObject buffers[3], vaos[3], feedbacks[2];
    for (int i : {first, second, unborn_flakes}) {
        buffers[i] = make_buffer();
        vaos[i] = make_vertex_array();
        glBindVertexArray(vaos[i]);
        glBindBuffer(GL_ARRAY_BUFFER, buffers[i]);
        glBufferData(GL_ARRAY_BUFFER, bytes, i == unborn_flakes ? waiting.data() : nullptr,
                     GL_DYNAMIC_COPY);
        check_memory("the flakes", double(bytes));
        describe_particles(sizeof(LiveFlake));
        glEnableVertexAttribArray(4);
        glVertexAttribIPointer(4, 1, GL_UNSIGNED_INT, sizeof(LiveFlake),
                               reinterpret_cast<const void*>(offsetof(LiveFlake, index)));
    }
    int now = first;  // the buffer that holds the flakes as they are

    UniformBlock<Weather> weather_block;
    Program update({{GL_VERTEX_SHADER, "step04_transform_feedback/update_geometry.vert"},
                    {GL_GEOMETRY_SHADER, "step04_transform_feedback/update.geom"}},
                   {"position", "age", "velocity", "rest", "index"});
    Program flake({{GL_VERTEX_SHADER, "step04_transform_feedback/flake_geometry.vert"},
                   {GL_FRAGMENT_SHADER, "step03_shader_points/flake.frag"}});

    // Each knows its buffer, and how much was written there last: nothing yet.
    update.use();
    for (int i : {first, second}) {
        feedbacks[i] = GlObject(glGenTransformFeedbacks, glDeleteTransformFeedbacks);
        glBindTransformFeedback(GL_TRANSFORM_FEEDBACK, feedbacks[i]);
        glBindBufferBase(GL_TRANSFORM_FEEDBACK_BUFFER, FEEDBACK_BUFFER, buffers[i]);
        glBeginTransformFeedback(GL_POINTS);
        glEndTransformFeedback();
    }

    glEnable(GL_PROGRAM_POINT_SIZE);  // the size comes from the vertex shader
    glEnable(GL_POINT_SPRITE);        // and gl_PointCoord with it
    glBlendFunc(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA);
    glClearColor(0.13f, 0.09f, 0.08f, 1.0f);
    while (window.begin_frame()) {
        glViewport(0, 0, window.size().x, window.size().y);
        glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
        draw_ground(window);
        weather_block.update(WEATHER_BLOCK, weather);
        {
            const auto stage = window.stage("update");
            update.use();
            for (; window.next_tick(); ++tick) {
                update.set("tick", tick);
                glEnable(GL_RASTERIZER_DISCARD);  // vertices are computed, nothing is drawn
                glBindTransformFeedback(GL_TRANSFORM_FEEDBACK, feedbacks[1 - now]);
                glBeginTransformFeedback(GL_POINTS);
                // Those that live on; then the successors of those that do not, and the new.
                glBindVertexArray(vaos[now]);
                update.set("births", false);
                glDrawTransformFeedback(GL_POINTS, feedbacks[now]);
                update.set("births", true);
                glDrawTransformFeedback(GL_POINTS, feedbacks[now]);
                const auto due =
                    std::partition_point(next_born, waiting.end(), [&](const LiveFlake& one) {
                        return waited(one.particle, tick + 1, weather).age >= 0.0f;
                    });
                glBindVertexArray(vaos[unborn_flakes]);
                glDrawArrays(GL_POINTS, GLint(next_born - waiting.begin()),
                             GLsizei(due - next_born));
                next_born = due;
                glEndTransformFeedback();
                glDisable(GL_RASTERIZER_DISCARD);
                now = 1 - now;
            }
        }
        {
            const auto stage = window.stage("draw");
            flake.use();
            flake.set("view", window.view());
            flake.set("projection", window.projection());
            flake.set("window_height", float(window.size().y));
            glBindVertexArray(vaos[now]);
            glEnable(GL_BLEND);
            glDrawTransformFeedback(GL_POINTS, feedbacks[now]);
            glDisable(GL_BLEND);
        }
        window.swap_buffers();
    }
    // Put back in the order of their indices, as the other variants have them. A flake that is gone
    // has a successor at once, so as many live as were ever born for the first time.
    std::vector<LiveFlake> live_flakes(size_t(next_born - waiting.begin()));
    glBindBuffer(GL_ARRAY_BUFFER, buffers[now]);
    glGetBufferSubData(GL_ARRAY_BUFFER, 0, GLsizeiptr(live_flakes.size() * sizeof(LiveFlake)),
                       live_flakes.data());
    check_read_back("the flakes");
    for (const LiveFlake& one : live_flakes) flakes[one.index] = one.particle;
    for (; next_born != waiting.end(); ++next_born) {
        flakes[next_born->index] = waited(next_born->particle, tick, weather);
    }
    window.dump(flakes);
}
