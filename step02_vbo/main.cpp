// Step 2: same as step 1, but the flakes travel to the GPU in one piece: one upload into a vertex
// buffer, one draw call for each size of point. The cost moves from 20,000 function calls to one
// copy. New calls: glBindBuffer, glBufferData, glBufferSubData, glVertexPointer, glDrawArrays.

#include <GL/glew.h>

#include <glm/gtc/type_ptr.hpp>

#include "common/gl_object.hpp"
#include "common/window.hpp"
#include "step01_cpu_points/ground.hpp"
#include "step01_cpu_points/update.hpp"
#include "step02_vbo/usage.hpp"

using namespace snow;

void run(Window& window)
{
    const Options& options = window.options();
    const Weather& weather = options.weather;
    const bool orphan = options.variant == "orphan";
    const GLenum hint = usage(options.hint);

    std::vector<Particle> flakes = make_flakes(weather);
    uint tick = 0;  // time steps made so far
    const GLsizeiptr bytes = GLsizeiptr(flakes.size() * sizeof(Particle));
    const GlObject buffer = make_buffer();
    glBindBuffer(GL_ARRAY_BUFFER, buffer);
    glBufferData(GL_ARRAY_BUFFER, bytes, nullptr, hint);
    check_memory("the flakes", double(bytes));

    glClearColor(0.05f, 0.10f, 0.10f, 1.0f);
    while (window.begin_frame()) {
        glViewport(0, 0, window.size().x, window.size().y);
        glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
        draw_ground(window);
        {
            const auto stage = window.stage("update");
            while (window.next_tick()) update_in_one_loop(flakes, tick++, weather);
        }
        {
            const auto stage = window.stage("upload");
            glBindBuffer(GL_ARRAY_BUFFER, buffer);
            // The draw of the frame before may still be reading: the driver copies, or waits.
            // Unless the buffer gets new storage first, and leaves the old to the GPU: an orphan.
            if (orphan) glBufferData(GL_ARRAY_BUFFER, bytes, nullptr, hint);
            glBufferSubData(GL_ARRAY_BUFFER, 0, bytes, flakes.data());
        }
        {
            const auto stage = window.stage("draw");
            glMatrixMode(GL_PROJECTION);
            glLoadMatrixf(value_ptr(window.projection()));
            glMatrixMode(GL_MODELVIEW);
            glLoadMatrixf(value_ptr(window.view()));
            // Positions lie sizeof(Particle) bytes apart in the buffer that is bound.
            glEnableClientState(GL_VERTEX_ARRAY);
            glVertexPointer(3, GL_FLOAT, sizeof(Particle), nullptr);
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
    window.dump(flakes);
}

void run_persistent(Window& window);  // persistent.cpp
void run_arrays(Window& window);      // arrays.cpp
void run_soa(Window& window);         // soa.cpp

int main(int argc, char** argv)
{
    Lesson lesson;
    lesson.name = "step02_vbo";
    lesson.idea = "the snow of step 1, uploaded to a vertex buffer and drawn with one call";
    lesson.minimum_gl = 1.5;
    lesson.variants = {{"subdata", run},
                       {"orphan", run},
                       {"persistent", run_persistent},
                       {"arrays", run_arrays},
                       {"soa", run_soa}};
    lesson.fixed_points = true;
    lesson.hinted = {"subdata", "orphan", "soa"};
    return run_lesson(argc, argv, lesson);
}
