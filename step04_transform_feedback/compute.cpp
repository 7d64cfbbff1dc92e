// The variant "compute": same as main.cpp, but a compute shader moves the flakes. It does not
// belong to drawing and may write anywhere in a buffer, so it needs one buffer instead of two. But
// OpenGL no longer keeps reads and writes of that buffer in order by itself: barriers do.

#include <GL/glew.h>

#include <stdexcept>

#include "common/program.hpp"
#include "common/uniform_block.hpp"
#include "common/window.hpp"
#include "step01_cpu_points/ground.hpp"
#include "step03_shader_points/particle_layout.hpp"

using namespace snow;

void run_compute(Window& window)
{
    const Options& options = window.options();
    const Weather& weather = options.weather;
    if (!GLEW_VERSION_4_3) {
        throw std::runtime_error("--variant compute needs OpenGL 4.3: try feedback");
    }

    std::vector<Particle> flakes = make_flakes(weather);
    uint tick = 0;  // time steps made so far
    const GLsizeiptr bytes = GLsizeiptr(flakes.size() * sizeof(Particle));
    GLint64 largest = 0;  // bytes that a shader can reach in one buffer
    glGetInteger64v(GL_MAX_SHADER_STORAGE_BLOCK_SIZE, &largest);
    if (bytes > largest) {
        throw std::runtime_error("--variant compute: too many flakes for this card: try feedback");
    }
    const GlObject buffer = make_buffer();
    const GlObject vao = make_vertex_array();
    glBindVertexArray(vao);
    glBindBuffer(GL_ARRAY_BUFFER, buffer);
    glBufferData(GL_ARRAY_BUFFER, bytes, flakes.data(), GL_DYNAMIC_COPY);
    check_memory("the flakes", double(bytes));
    describe_particles();

    UniformBlock<Weather> weather_block;
    Program update({{GL_COMPUTE_SHADER, "step04_transform_feedback/update.comp"}});
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
                glBindBufferBase(GL_SHADER_STORAGE_BUFFER, FLAKES_BUFFER, buffer);
                // Behind it this reads what the last update wrote, and writes only when the last
                // draw has fetched its vertices.
                glMemoryBarrier(GL_SHADER_STORAGE_BARRIER_BIT);
                glDispatchCompute(GLuint(flakes.size() + 1023) / 1024, 1, 1);
            }
            glMemoryBarrier(GL_VERTEX_ATTRIB_ARRAY_BARRIER_BIT);  // the draw reads what this wrote
        }
        {
            const auto stage = window.stage("draw");
            flake.use();
            flake.set("view", window.view());
            flake.set("projection", window.projection());
            flake.set("window_height", float(window.size().y));
            glBindVertexArray(vao);
            glEnable(GL_BLEND);
            glDrawArrays(GL_POINTS, 0, GLsizei(flakes.size()));
            glDisable(GL_BLEND);
        }
        window.swap_buffers();
    }
    glMemoryBarrier(GL_BUFFER_UPDATE_BARRIER_BIT);  // and so does the copy
    glBindBuffer(GL_ARRAY_BUFFER, buffer);
    glGetBufferSubData(GL_ARRAY_BUFFER, 0, bytes, flakes.data());
    check_read_back("the flakes");
    window.dump(flakes);
}
