// Step 4: same as step 3, but the update runs on the GPU as well: a vertex shader moves each flake,
// and transform feedback writes the result to a second buffer; then the two change roles. After the
// start no flake ever crosses the bus again, so the upload is gone.

#include <GL/glew.h>

#include "common/program.hpp"
#include "common/uniform_block.hpp"
#include "common/window.hpp"
#include "step01_cpu_points/ground.hpp"
#include "step03_shader_points/particle_layout.hpp"

using namespace snow;

void run(Window& window)
{
    const Options& options = window.options();
    const Weather& weather = options.weather;

    std::vector<Particle> flakes = make_flakes(weather);
    uint tick = 0;  // time steps made so far
    const GLsizeiptr bytes = GLsizeiptr(flakes.size() * sizeof(Particle));
    // Ping-pong: an update reads one buffer and writes the other; it may not do both to the same.
    GlObject buffers[2], vaos[2];
    for (int i = 0; i < 2; ++i) {
        buffers[i] = make_buffer();
        vaos[i] = make_vertex_array();
        glBindVertexArray(vaos[i]);
        glBindBuffer(GL_ARRAY_BUFFER, buffers[i]);
        glBufferData(GL_ARRAY_BUFFER, bytes, flakes.data(), GL_DYNAMIC_COPY);
        check_memory("the flakes", double(bytes));
        describe_particles();
    }
    int now = 0;  // the buffer that holds the flakes as they are

    UniformBlock<Weather> weather_block;
    Program update({{GL_VERTEX_SHADER, "step04_transform_feedback/update.vert"}},
                   {"position", "age", "velocity", "rest"});
    Program flake({{GL_VERTEX_SHADER, "step03_shader_points/flake.vert"},
                   {GL_FRAGMENT_SHADER, "step03_shader_points/flake.frag"}});

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
                glBindVertexArray(vaos[now]);
                glBindBufferBase(GL_TRANSFORM_FEEDBACK_BUFFER, FEEDBACK_BUFFER, buffers[1 - now]);
                glBeginTransformFeedback(GL_POINTS);
                glDrawArrays(GL_POINTS, 0, GLsizei(flakes.size()));
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
            glDrawArrays(GL_POINTS, 0, GLsizei(flakes.size()));
            glDisable(GL_BLEND);
        }
        window.swap_buffers();
    }
    glBindBuffer(GL_ARRAY_BUFFER, buffers[now]);
    glGetBufferSubData(GL_ARRAY_BUFFER, 0, bytes, flakes.data());
    check_read_back("the flakes");
    window.dump(flakes);
}

void run_texture(Window& window);   // texture.cpp
void run_compute(Window& window);   // compute.cpp
void run_geometry(Window& window);  // geometry.cpp

int main(int argc, char** argv)
{
    Lesson lesson;
    lesson.name = "step04_transform_feedback";
    lesson.idea = "the snow of step 3, moved by the GPU as well as drawn by it";
    lesson.minimum_gl = 3.3;
    lesson.variants = {{"feedback", run},
                       {"texture", run_texture},
                       {"compute", run_compute},
                       {"geometry", run_geometry}};
    return run_lesson(argc, argv, lesson);
}
