// The variant "arrays": same as main.cpp, but there is no buffer: OpenGL is told where in the
// program's own memory the flakes are, and fetches them itself whenever it draws. So it was done
// between glBegin (1992) and buffers (2003), and so it no longer is: core profiles do not have it.

#include <GL/glew.h>

#include <glm/gtc/type_ptr.hpp>

#include "common/window.hpp"
#include "step01_cpu_points/ground.hpp"
#include "step01_cpu_points/update.hpp"

using namespace snow;

void run_arrays(Window& window)
{
    const Options& options = window.options();
    const Weather& weather = options.weather;

    std::vector<Particle> flakes = make_flakes(weather);
    uint tick = 0;  // time steps made so far

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
            const auto stage = window.stage("draw");
            glMatrixMode(GL_PROJECTION);
            glLoadMatrixf(value_ptr(window.projection()));
            glMatrixMode(GL_MODELVIEW);
            glLoadMatrixf(value_ptr(window.view()));
            // Positions lie sizeof(Particle) bytes apart in our own memory: no buffer is bound, so
            // the last argument is an address. They are read when they are drawn, not before.
            glBindBuffer(GL_ARRAY_BUFFER, 0);
            glEnableClientState(GL_VERTEX_ARRAY);
            glVertexPointer(3, GL_FLOAT, sizeof(Particle), flakes.data());
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
