// Step 2: same as step 1, but the flakes travel to the GPU in one piece: one upload into a vertex
// buffer, one draw call for each size of point.

#include <GL/glew.h>

#include "common/gl_object.hpp"
#include "common/window.hpp"
#include "step01_cpu_points/ground.hpp"
#include "step01_cpu_points/groups.hpp"
#include "step01_cpu_points/update.hpp"

using namespace snow;

void run(Window& window)
{
    const Options& options = window.options();
    const Weather& weather = options.weather;
    const bool orphan = options.variant == "orphan", arrays = options.variant == "arrays";

    std::vector<Particle> flakes = make_flakes(weather);
    uint tick = 0;                                           // time steps made so far
    const std::vector<Group> groups = make_groups(options);  // flakes of one size
    const GLsizeiptr bytes = GLsizeiptr(flakes.size() * sizeof(Particle));
    const GlObject buffer = make_buffer();
    glBindBuffer(GL_ARRAY_BUFFER, buffer);
    glBufferData(GL_ARRAY_BUFFER, bytes, nullptr, GL_STREAM_DRAW);
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
        if (!arrays) {
            const auto stage = window.stage("upload");
            glBindBuffer(GL_ARRAY_BUFFER, buffer);
            // The draw of the frame before may still be reading: the driver copies, or waits.
            // Unless the buffer gets new storage first, and leaves the old to the GPU: an orphan.
            if (orphan) glBufferData(GL_ARRAY_BUFFER, bytes, nullptr, GL_STREAM_DRAW);
            glBufferSubData(GL_ARRAY_BUFFER, 0, bytes, flakes.data());
        }
        {
            const auto stage = window.stage("draw");
            load_matrices(window);
            // Positions lie sizeof(Particle) bytes apart in the buffer that is bound; if none is,
            // at that address in our own memory.
            glBindBuffer(GL_ARRAY_BUFFER, arrays ? 0 : GLuint(buffer));
            glEnableClientState(GL_VERTEX_ARRAY);
            glVertexPointer(3, GL_FLOAT, sizeof(Particle), arrays ? flakes.data() : nullptr);
            for (const Group& group : groups) {
                glPointSize(group.point_size);
                glDrawArrays(GL_POINTS, GLint(group.begin), GLsizei(group.end - group.begin));
            }
        }
        window.swap_buffers();
    }
    window.dump(flakes);
}

void run_persistent(Window& window);  // persistent.cpp
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
                       {"arrays", run},
                       {"soa", run_soa}};
    lesson.fixed_points = true;
    return run_lesson(argc, argv, lesson);
}
