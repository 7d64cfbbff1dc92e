// Step 1: snow on the CPU. Every flake is a struct in an array; each frame a loop moves all of them
// with Euler's method, and a second loop hands each one to OpenGL with a function call of its own.
// Two clouds release two kinds of flake.

#include <GL/glew.h>

#include <glm/gtc/type_ptr.hpp>

#include "common/window.hpp"
#include "step01_cpu_points/ground.hpp"
#include "step01_cpu_points/groups.hpp"
#include "step01_cpu_points/update.hpp"

using namespace snow;

void run(Window& window)
{
    const Options& options = window.options();
    const Weather& weather = options.weather;
    auto update = update_in_one_loop;
    if (options.variant == "plain") update = update_plainly;
    if (options.variant == "three-loops") update = update_in_three_loops;
    if (options.variant == "threads") update = update_on_all_cores;

    std::vector<Particle> flakes = make_flakes(weather);
    uint tick = 0;                                           // time steps made so far
    const std::vector<Group> groups = make_groups(options);  // flakes of one size

    glClearColor(0.05f, 0.07f, 0.12f, 1.0f);
    while (window.begin_frame()) {
        glViewport(0, 0, window.size().x, window.size().y);
        glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
        draw_ground(window);
        {
            const auto stage = window.stage("update");
            while (window.next_tick()) update(flakes, tick++, weather);
        }
        {
            const auto stage = window.stage("draw");
            load_matrices(window);
            for (const Group& group : groups) {
                glPointSize(group.point_size);
                glBegin(GL_POINTS);
                for (uint i = group.begin; i < group.end; ++i) {
                    glVertex3fv(value_ptr(flakes[i].position));
                }
                glEnd();
            }
        }
        window.swap_buffers();
    }
    window.dump(flakes);
}

void run_hexagons(Window& window);  // hexagons.cpp

int main(int argc, char** argv)
{
    Lesson lesson;
    lesson.name = "step01_cpu_points";
    lesson.idea = "snow moved by a loop on the CPU and drawn point by point with glBegin and glEnd";
    lesson.minimum_gl = 1.5;
    lesson.variants = {{"one-loop", run},
                       {"plain", run},
                       {"three-loops", run},
                       {"threads", run},
                       {"hexagons", run_hexagons}};
    lesson.fixed_points = true;
    return run_lesson(argc, argv, lesson);
}
