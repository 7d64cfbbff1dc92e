// The variant "heightmap": same as main.cpp, but the snow lies on what is seen from above, with one
// depth in each column, as others had it before there were cells (Haglund and others 2002, Saltvik
// and others 2006). New calls: glDrawBuffer, GL_DEPTH_ATTACHMENT (in heightmap/height_map.cpp).

#include <GL/glew.h>

#include "common/program.hpp"
#include "common/uniform_block.hpp"
#include "common/window.hpp"
#include "step04_transform_feedback/particle_buffer.hpp"
#include "step05_collision/ledger.hpp"
#include "step05_collision/solid_scene.hpp"
#include "step06_accumulation/cover/snow_cover.hpp"
#include "step06_accumulation/heightmap/height_map.hpp"

using namespace snow;

void run_heightmap(Window& window, const SolidScene& solid)
{
    const Options& options = window.options();
    const Weather& weather = options.weather;

    std::vector<Particle> flakes = make_flakes(weather);
    uint tick = 0;  // time steps made so far
    const ParticleBuffer particles(flakes);
    SnowCover cover(options.voxels, 1);  // one layer
    const Ledger ledger;
    HeightMap map(solid, cover);

    UniformBlock<Weather> weather_block;
    Program update({{GL_COMPUTE_SHADER, "step06_accumulation/heightmap/update.comp"}});
    Program surface({{GL_VERTEX_SHADER, "step06_accumulation/heightmap/scene.vert"},
                     {GL_FRAGMENT_SHADER, "step06_accumulation/heightmap/scene.frag"}});
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
            map.bind();
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
            map.settle(tick, window.ticks());
        }
        {
            const auto stage = window.stage("scene");
            surface.use();
            surface.set("view", window.view());
            surface.set("projection", window.projection());
            surface.set("eye", window.eye());
            surface.set("fog", sky);
            map.bind();
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
