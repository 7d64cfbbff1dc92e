// The variant "threads": same as main.cpp, but all cores move flakes: each takes blocks of its own.
// No flake knows of another, so it does not matter who moves which, and when. New: #pragma omp.

#include <GL/glew.h>

#include <cstddef>
#include <glm/gtc/type_ptr.hpp>
#include <stdexcept>

#include "common/window.hpp"
#include "step01_cpu_points/ground.hpp"
#include "step01_cpu_points/update.hpp"

using namespace snow;

// The loop of update_in_one_loop, which OpenMP deals out: to each core as many blocks in a row.
static void update_on_all_cores(std::span<Particle> flakes, uint tick, Weather weather)
{
    const auto size = std::ptrdiff_t(flakes.size());  // OpenMP 2 counts with signs
#ifdef _OPENMP
#pragma omp parallel for schedule(static) firstprivate(weather)
#endif
    for (std::ptrdiff_t begin = 0; begin < size; begin += std::ptrdiff_t(block)) {
        update_block(block_at(flakes, size_t(begin)), uint(begin), tick, weather);
    }
}

void run_threads(Window& window)
{
    const Options& options = window.options();
    const Weather& weather = options.weather;
#ifndef _OPENMP
    throw std::runtime_error("--variant threads: this compiler has no OpenMP: try one-loop");
#endif

    std::vector<Particle> flakes = make_flakes(weather);
    uint tick = 0;  // time steps made so far

    glClearColor(0.05f, 0.07f, 0.12f, 1.0f);
    while (window.begin_frame()) {
        glViewport(0, 0, window.size().x, window.size().y);
        glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
        draw_ground(window);
        {
            const auto stage = window.stage("update");
            while (window.next_tick()) update_on_all_cores(flakes, tick++, weather);
        }
        {
            const auto stage = window.stage("draw");
            glMatrixMode(GL_PROJECTION);
            glLoadMatrixf(value_ptr(window.projection()));
            glMatrixMode(GL_MODELVIEW);
            glLoadMatrixf(value_ptr(window.view()));
            // In pieces, for points of two sizes: the first half of the pool is emitter 0's, of
            // small flakes, the second half emitter 1's.
            for (uint group = 0; group < options.groups; ++group) {
                const uint begin = options.group_begin(group), end = options.group_begin(group + 1);
                glPointSize(options.point_size * (of_first_emitter(begin, weather) ? 1.0f : 2.0f));
                glBegin(GL_POINTS);
                for (uint i = begin; i < end; ++i) glVertex3fv(value_ptr(flakes[i].position));
                glEnd();
            }
        }
        window.swap_buffers();
    }
    window.dump(flakes);
}
