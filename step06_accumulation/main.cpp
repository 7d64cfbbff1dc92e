// Step 6: same as step 5, but the snow stays: a flake that has lain for its time adds its mass to
// the cell it lies in, in a buffer that every shader may read and write. A full cell is solid to
// the flakes that follow, and the scene is drawn lifted and whitened by the snow upon it. New
// calls: GL_SHADER_STORAGE_BUFFER (in cover/snow_cover.cpp), glMemoryBarrier, glDispatchCompute (in
// cover/columns.cpp), and atomicAdd and atomicCompSwap in the shader.

#include <GL/glew.h>

#include "common/program.hpp"
#include "common/uniform_block.hpp"
#include "common/window.hpp"
#include "step04_transform_feedback/ping_pong.hpp"
#include "step05_collision/ledger.hpp"
#include "step05_collision/solid_scene.hpp"
#include "step06_accumulation/cover/columns.hpp"
#include "step06_accumulation/cover/snow_cover.hpp"

using namespace snow;

void run(Window& window, const SolidScene& solid)
{
    const Options& options = window.options();
    const Weather& weather = options.weather;

    std::vector<Particle> flakes = make_flakes(weather);
    uint tick = 0;  // time steps made so far
    PingPong particles(flakes);
    SnowCover cover(options.voxels);
    const Ledger ledger;
    Columns columns(solid, cover);

    UniformBlock<Weather> weather_block;
    Program update({{GL_VERTEX_SHADER, "step06_accumulation/update.vert"}},
                   {"position", "age", "velocity", "rest"});
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
            set_voxels(update, solid);
            set_terrain(update, solid);
            ledger.bind();
            cover.bind();
            update.set("flake_mass", cover.flake_mass(weather, solid.grid));
            for (; window.next_tick(); ++tick) {
                update.set("tick", tick);
                glEnable(GL_RASTERIZER_DISCARD);  // vertices are computed, nothing is drawn
                glBindVertexArray(particles.vao());
                glBindBufferBase(GL_TRANSFORM_FEEDBACK_BUFFER, FEEDBACK_BUFFER, particles.target());
                glBeginTransformFeedback(GL_POINTS);
                glDrawArrays(GL_POINTS, 0, GLsizei(flakes.size()));
                glEndTransformFeedback();
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
        {
            const auto stage = window.stage("scene");
            surface.use();
            surface.set("view", window.view());
            surface.set("projection", window.projection());
            surface.set("eye", window.eye());
            surface.set("fog", sky);
            columns.set_depth(surface);
            draw_scene(surface, solid);
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

void run_winter(Window& window, const SolidScene& solid);  // winter.cpp
std::vector<Parameter> winter_parameters();

// Reads the scene once, however often the snow begins anew.
void load_and_run(Window& window)
{
    const SolidScene solid(window);
    do {
        if (window.options().variant == "winter")
            run_winter(window, solid);
        else
            run(window, solid);
    } while (window.restarted());
}

int main(int argc, char** argv)
{
    Lesson lesson;
    lesson.name = "step06_accumulation";
    lesson.idea = "the snow of step 5, piling up on the scene: the full system";
    lesson.minimum_gl = 4.3;
    lesson.variants = {{"winter", load_and_run, winter_parameters()},
                       {"cells", load_and_run, Columns::parameters()}};
    lesson.has_scene = true;
    lesson.has_cover = true;
    lesson.limits = {{GL_MAX_VERTEX_ATOMIC_COUNTERS, 8, "atomic counters in vertex shaders"},
                     {GL_MAX_VERTEX_SHADER_STORAGE_BLOCKS, 2, "storage buffers in vertex shaders"}};
    return run_lesson(argc, argv, lesson);
}
