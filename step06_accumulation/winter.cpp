// The variant "winter": same as main.cpp, but the full system. The wind flows around the scene, the
// snow is lit, shaded and as smooth as it needs to be, flakes are crystals, drops or hailstones,
// and fewer of them move where frames take too long. What each part does is in a folder of winter/.

#include <GL/glew.h>

#include "common/program.hpp"
#include "common/uniform_block.hpp"
#include "common/window.hpp"
#include "step04_transform_feedback/ping_pong.hpp"
#include "step05_collision/ledger.hpp"
#include "step05_collision/solid_scene.hpp"
#include "step06_accumulation/cover/columns.hpp"
#include "step06_accumulation/cover/snow_cover.hpp"
#include "step06_accumulation/winter/winter.hpp"

using namespace snow;

std::vector<Parameter> winter_parameters()
{
    return Winter::parameters();
}

void run_winter(Window& window, const SolidScene& solid)
{
    const Options& options = window.options();
    const Weather& weather = options.weather;

    std::vector<Particle> flakes = make_flakes(weather);
    uint tick = 0;  // time steps made so far
    PingPong particles(flakes);
    SnowCover cover(options.voxels);
    const Ledger ledger;
    Columns columns(solid, cover);
    Winter winter(window, solid, columns);

    UniformBlock<Weather> weather_block;
    Permutations updates({{GL_VERTEX_SHADER, "step06_accumulation/winter/wind/update.vert"}},
                         {"position", "age", "velocity", "rest"});

    glEnable(GL_DEPTH_TEST);
    glEnable(GL_PROGRAM_POINT_SIZE);  // the size comes from the vertex shader
    glEnable(GL_POINT_SPRITE);        // and gl_PointCoord with it
    glBlendFunc(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA);
    while (window.begin_frame()) {
        glViewport(0, 0, window.size().x, window.size().y);
        weather_block.update(WEATHER_BLOCK, weather);
        winter.choose_flakes(window, particles);
        {
            const auto stage = window.stage("update");
            Program& update = winter.use_in_wind(updates, weather);
            set_voxels(update, solid);
            set_terrain(update, solid);
            ledger.bind();
            cover.bind();
            update.set("flake_mass",
                       cover.flake_mass(weather, solid.grid) * winter.live().weight());
            for (; window.next_tick(); ++tick) {
                update.set("tick", tick);
                glEnable(GL_RASTERIZER_DISCARD);  // vertices are computed, nothing is drawn
                glBindVertexArray(particles.vao());
                for (const Range& half : winter.live()) {
                    if (half.count == 0) continue;  // an empty range may not be bound
                    glBindBufferRange(GL_TRANSFORM_FEEDBACK_BUFFER, FEEDBACK_BUFFER,
                                      particles.target(), begin_of(half), size_of(half));
                    glBeginTransformFeedback(GL_POINTS);
                    glDrawArrays(GL_POINTS, half.first, half.count);
                    glEndTransformFeedback();
                }
                glDisable(GL_RASTERIZER_DISCARD);
                glMemoryBarrier(GL_SHADER_STORAGE_BARRIER_BIT);  // who reads next sees this snow
                particles.swap();
            }
        }
        if (Columns::settling) {
            const auto stage = window.stage("settle");
            columns.settle(tick, window.ticks());
        }
        if (Columns::melting) {
            const auto stage = window.stage("melt");
            columns.melt(tick, window.ticks(), weather);
        }
        {
            const auto stage = window.stage("depth");
            columns.measure(tick, window.ticks());
        }
        winter.draw(window, tick, particles);
        window.swap_buffers();
    }
    particles.read(flakes);
    window.dump(flakes);
    ledger.print(flakes);
    cover.report(solid.grid, options.dump_cover);
}
