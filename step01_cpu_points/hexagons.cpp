// The variant "hexagons": same as main.cpp, but every flake is a crystal, twelve calls instead of
// one, and its size is its own.

#include <GL/glew.h>

#include <glm/gtc/type_ptr.hpp>

#include "common/window.hpp"
#include "step01_cpu_points/ground.hpp"
#include "step01_cpu_points/update.hpp"

using namespace snow;

// A flake as a crystal: six needles from its centre in the plane that faces the camera.
static void draw_crystal(const Particle& flake, float radius, vec3 right, vec3 up)
{
    for (int needle = 0; needle < 6; ++needle) {
        const float angle = radians(60.0f * float(needle));
        const vec3 tip = flake.position + radius * (cos(angle) * right + sin(angle) * up);
        glVertex3fv(value_ptr(flake.position));
        glVertex3fv(value_ptr(tip));
    }
}

void run_hexagons(Window& window)
{
    const Options& options = window.options();
    const Weather& weather = options.weather;

    std::vector<Particle> flakes = make_flakes(weather);
    uint tick = 0;  // time steps made so far

    glClearColor(0.05f, 0.07f, 0.12f, 1.0f);
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
            load_matrices(window);
            const mat3 camera = transpose(mat3(window.view()));  // its right, up, back, world space
            glBegin(GL_LINES);
            for (uint i = 0; i < flakes.size(); ++i) {
                draw_crystal(flakes[i], 0.5f * diameter(i, weather), camera[0], camera[1]);
            }
            glEnd();
        }
        window.swap_buffers();
    }
    window.dump(flakes);
}
