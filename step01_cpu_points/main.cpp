// Step 1: snow on the CPU. Every flake is a struct in an array; each frame a loop moves all of them
// with Euler's method, and a second loop hands each one to OpenGL with a function call of its own.
// Two clouds release two kinds of flake. New calls: glBegin, glVertex3fv, glEnd, glPointSize.

#include <GL/glew.h>

#include <glm/gtc/type_ptr.hpp>

#include "common/options.hpp"
#include "common/output.hpp"
#include "common/window.hpp"
#include "step01_cpu_points/update.hpp"

using namespace snow;

const Step this_step = {
    .name = "step01_cpu_points",
    .idea = "snow moved by a loop on the CPU and drawn point by point with glBegin and glEnd",
    .least_gl = 1.5,
    .variants = {"one-loop", "three-loops", "hexagons"},
    .fixed_points = true,
};

// A flake as one point, as many pixels wide as glPointSize said.
void draw_point(const Particle& flake)
{
    glVertex3fv(value_ptr(flake.position));
}

// A flake as a crystal: six needles from its centre in the plane that faces the camera.
void draw_crystal(const Particle& flake, float radius, vec3 right, vec3 up)
{
    for (int needle = 0; needle < 6; ++needle) {
        const float angle = radians(60.0f * float(needle));
        const vec3 tip = flake.position + radius * (cos(angle) * right + sin(angle) * up);
        glVertex3fv(value_ptr(flake.position));
        glVertex3fv(value_ptr(tip));
    }
}

// From the first flake to the last frame, or until the panel asks for other flakes.
void run(Window& window)
{
    const Options& options = window.options();
    const Weather& weather = options.weather;
    const bool hexagons = options.variant == "hexagons";
    const auto update =
        options.variant == "three-loops" ? update_in_three_loops : update_in_one_loop;

    std::vector<Particle> flakes = make_flakes(weather);
    uint step = 0;

    glClearColor(0.05f, 0.07f, 0.12f, 1.0f);
    while (window.begin_frame()) {
        {
            const auto stage = window.stage("update");
            for (int n = 0; n < window.steps(); ++n) update(flakes, step++, weather);
        }
        {
            const auto stage = window.stage("draw");
            const mat4 view = window.view();
            const mat3 camera = transpose(mat3(view));  // its right, up and back, world space
            glMatrixMode(GL_PROJECTION);
            glLoadMatrixf(value_ptr(window.projection()));
            glMatrixMode(GL_MODELVIEW);
            glLoadMatrixf(value_ptr(view));
            // In pieces, for points of two sizes: the first half of the pool is emitter 0's, of
            // small flakes, the second half emitter 1's.
            for (uint group = 0; group < options.groups; ++group) {
                const uint begin = options.group_begin(group), end = options.group_begin(group + 1);
                glPointSize(options.point_size * (of_first_emitter(begin, weather) ? 1.0f : 2.0f));
                glBegin(hexagons ? GL_LINES : GL_POINTS);
                for (uint i = begin; i < end; ++i) {
                    if (hexagons) {
                        draw_crystal(flakes[i], 0.5f * diameter(i, weather), camera[0], camera[1]);
                    } else {
                        draw_point(flakes[i]);
                    }
                }
                glEnd();
            }
        }
    }
    dump_flakes(options.dump, flakes);
}

int main(int argc, char** argv)
{
    return run_step(argc, argv, this_step, run);
}
