// Step 6: same as step 5, but the snow stays: a flake that has lain for its time adds its mass to
// the cell it lies in, which is solid when it is full; the scene is drawn lifted and whitened. The
// update is a compute shader, as in step 4's compute.cpp: it runs exactly once for each flake. New
// calls: GL_SHADER_STORAGE_BUFFER (in cover/snow_cover.cpp), glMemoryBarrier, glDispatchCompute,
// and atomicAdd and atomicCompSwap in the shader.

#include <GL/glew.h>

#include "common/program.hpp"
#include "common/uniform_block.hpp"
#include "common/window.hpp"
#include "step04_transform_feedback/particle_buffer.hpp"
#include "step05_collision/ledger.hpp"
#include "step05_collision/solid_scene.hpp"
#include "step06_accumulation/cover/columns.hpp"
#include "step06_accumulation/cover/snow_cover.hpp"
#include "step06_accumulation/winter/settings.hpp"

using namespace snow;

void run(Window& window, const SolidScene& solid, const Settings& settings)
{
    const Options& options = window.options();
    const Weather& weather = options.weather;

    std::vector<Particle> flakes = make_flakes(weather);
    uint tick = 0;  // time steps made so far
    const ParticleBuffer particles(flakes);
    SnowCover cover(options.voxels, options.voxels);
    const Ledger ledger;
    Columns columns(solid, cover);

    UniformBlock<Weather> weather_block;
    Program update({{GL_COMPUTE_SHADER, "step06_accumulation/update.comp"}});
    Program surface({{GL_VERTEX_SHADER, "step06_accumulation/scene.vert"},
                     {GL_FRAGMENT_SHADER, "step06_accumulation/scene.frag"}});
    Program flake({{GL_VERTEX_SHADER, "step03_shader_points/flake.vert"},
                   {GL_FRAGMENT_SHADER, "step03_shader_points/flake.frag"}});

    const vec3 sky(0.30f, 0.34f, 0.42f);
    glEnable(GL_DEPTH_TEST);
    glEnable(GL_PROGRAM_POINT_SIZE);  // the size comes from the vertex shader
    glEnable(GL_POINT_SPRITE);        // and gl_PointCoord with it
    glBlendFunc(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA);
    glClearColor(sky.r, sky.g, sky.b, 1.0f);
    while (window.begin_frame()) {
        glViewport(0, 0, window.size().x, window.size().y);
        glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
        weather_block.update(WEATHER_BLOCK, weather);
        {
            const auto stage = window.stage("update");
            update.use();
            solid.bind();
            ledger.bind();
            cover.bind();
            update.set("flake_mass", cover.flake_mass(weather, solid.grid));
            for (; window.next_tick(); ++tick) {
                update.set("tick", tick);
                glMemoryBarrier(GL_SHADER_STORAGE_BARRIER_BIT);  // what came before is done
                particles.dispatch(update);
            }
            glMemoryBarrier(GL_VERTEX_ATTRIB_ARRAY_BARRIER_BIT);  // the draw reads the flakes
        }
        {
            const auto stage = window.stage("accumulate");
            if (settings.cover.settling) columns.settle(tick, window.ticks());
            if (settings.cover.melting) columns.melt(tick, window.ticks(), weather);
            columns.measure(tick, window.ticks());
        }
        {
            const auto stage = window.stage("scene");
            surface.use();
            surface.set("view", window.view());
            surface.set("projection", window.projection());
            surface.set("eye", window.eye());
            surface.set("fog", sky);
            bind_texture(DEPTH_UNIT, GL_TEXTURE_3D, columns.depth());
            solid.draw(surface);
        }
        {
            const auto stage = window.stage("draw");
            flake.use();
            flake.set("view", window.view());
            flake.set("projection", window.projection());
            flake.set("window_height", float(window.size().y));
            glBindVertexArray(particles.vao());
            glEnable(GL_BLEND);
            glDepthMask(GL_FALSE);  // flakes hide behind the scene, not behind each other
            glDrawArrays(GL_POINTS, 0, GLsizei(flakes.size()));
            glDepthMask(GL_TRUE);
            glDisable(GL_BLEND);
        }
        window.swap_buffers();
    }
    particles.read(flakes);
    window.dump(flakes);
    ledger.print(flakes);
    cover.report(solid.grid, options.dump_cover);
}

void run_heightmap(Window& window, const SolidScene& solid);  // heightmap.cpp
void run_winter(Window& window, const SolidScene& solid, const Settings& settings);  // winter.cpp

int main(int argc, char** argv)
{
    Settings settings;  // which --set and the panel change
    // Reads the scene once, however often the snow begins anew.
    const auto load_and_run = [&settings](Window& window) {
        const SolidScene solid(window);
        do {
            const std::string variant = window.options().variant;  // the panel changes that
            if (variant == "winter") run_winter(window, solid, settings);
            if (variant == "cells") run(window, solid, settings);
            if (variant == "heightmap") run_heightmap(window, solid);
        } while (window.restarted());
    };
    Lesson lesson;
    lesson.name = "step06_accumulation";
    lesson.idea = "the snow of step 5, piling up on the scene: the full system";
    lesson.minimum_gl = 4.3;
    lesson.variants = {{"winter", load_and_run, settings.parameters()},
                       {"cells", load_and_run, settings.cover.parameters()},
                       {"heightmap", load_and_run}};
    lesson.has_scene = true;
    lesson.has_cover = true;
    return run_lesson(argc, argv, lesson);
}
