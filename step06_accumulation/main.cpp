// Step 6: same as step 5, but the snow stays: a flake that has lain for its time adds its mass to
// the cell it lies in, in a buffer that every shader may read and write. A full cell is solid to
// the flakes that follow, and the scene is drawn lifted and whitened by the snow upon it. New
// calls: GL_SHADER_STORAGE_BUFFER, glMemoryBarrier, and atomicAdd in the shader.

#include <GL/glew.h>

#include "common/options.hpp"
#include "common/output.hpp"
#include "common/program.hpp"
#include "common/texture.hpp"
#include "common/window.hpp"
#include "step03_shader_points/particle_layout.hpp"
#include "step05_collision/ledger.hpp"
#include "step05_collision/scene_collider.hpp"
#include "step05_collision/solid_scene.hpp"
#include "step06_accumulation/ambient_occlusion.hpp"
#include "step06_accumulation/columns.hpp"
#include "step06_accumulation/frame.hpp"
#include "step06_accumulation/frame_rate.hpp"
#include "step06_accumulation/lamp.hpp"
#include "step06_accumulation/light.hpp"
#include "step06_accumulation/shadow_map.hpp"
#include "step06_accumulation/snow_cover.hpp"
#include "step06_accumulation/snow_surface.hpp"
#include "step06_accumulation/wind_arrows.hpp"
#include "step06_accumulation/wind_field.hpp"

using namespace snow;

const Step this_step = {
    .name = "step06_accumulation",
    .idea = "the snow of step 5, piling up on the scene: the full system",
    .least_gl = 4.3,
    .variants = {"cells"},
    .has_scene = true,
    .has_cover = true,
    .settings =
        {
            a_switch("tessellation", true, "the surface of the snow is as fine as it needs to be"),
            a_switch("sparkle", true, "crystals on the snow flash in the sun"),
            a_switch("settling", true, "snow steeper than its angle of repose slides"),
            a_switch("melting", true, "snow melts where it is warmer than 0 degrees"),
            a_switch("billboards", true, "flakes are crystals, drawn out along their way"),
            a_switch("splashes", true, "of drops that reach the ground"),
            a_switch("wind_field", true, "the wind flows around the scene"),
            a_switch("arrows", false, "the wind as arrows, the redder the faster", 'W'),
            a_switch("sky", true, "sky, and a field around the scene"),
            a_switch("shadow", true, "the scene keeps the sun from what lies behind it"),
            a_switch("occlusion", true, "it is darker where less of the sky is seen"),
            a_switch("fog", true, "the air, and more so with snow in it, hides what is far"),
            a_switch("lamp", true, "the lamp, lit from dusk on"),
            {"sun_height", "degrees", -20, 80, 20, "of the sun above the horizon"},
            {"sun_direction", "degrees", 0, 360, 118, "where the sun stands, from +z towards +x"},
            {"exposure", "", 0.1f, 10, 1, "of the picture"},
            {"hold_fps", "fps", 0, 240, 0, "frame rate to hold by moving fewer flakes; 0: none"},
            {"live", "", 0.01f, 1, 1, "part of the flakes that moves at most, each the heavier"},
            {"gusts", "", 0, 2, 0.3f, "largest change of the wind in a gust, relative"},
        },
};

// What the programs of all runs share.
struct World {
    explicit World(const Options& options) : solid(options), wind(solid.grid), occlusion(solid.grid)
    {}

    SolidScene solid;
    WindField wind;
    AmbientOcclusion occlusion;
};

// From the first flake to the last frame, or until the panel asks for other flakes.
void run(Window& window, const World& world)
{
    const Options& options = window.options();
    const Weather& weather = options.weather;

    std::vector<Particle> flakes = make_flakes(weather);
    uint step = 0;
    // Ping-pong: an update reads one buffer and writes the other; it may not do both to the same.
    GlObject buffers[2], vaos[2];
    for (int i = 0; i < 2; ++i) {
        buffers[i] = make_buffer();
        vaos[i] = make_vertex_array();
        glBindVertexArray(vaos[i]);
        glBindBuffer(GL_ARRAY_BUFFER, buffers[i]);
        glBufferData(GL_ARRAY_BUFFER, GLsizeiptr(flakes.size() * sizeof(Particle)), flakes.data(),
                     GL_DYNAMIC_COPY);
        describe_particles();
    }
    int now = 0;  // the buffer that holds the flakes as they are
    FrameRate frame_rate;
    LiveFlakes live(weather.particles);

    const SolidScene& solid = world.solid;
    SnowCover cover(solid.grid);
    Columns columns(solid.grid);
    const Ledger ledger;

    FrameBlock frame;
    WindArrows arrows;
    Lighting lighting(solid);
    Lamp lamp(solid.scene);
    ShadowMap shadow_map;
    GlObject weather_block = upload_weather(weather);
    Program update({{GL_VERTEX_SHADER, "step06_accumulation/update.vert"}},
                   {"position", "age", "velocity", "rest"});
    Program backdrop({{GL_VERTEX_SHADER, "step04_transform_feedback/full_screen.vert"},
                      {GL_FRAGMENT_SHADER, "step06_accumulation/sky.frag"}});
    SnowSurface surface(solid.scene, solid.grid.cell_size);
    Program sprite({{GL_VERTEX_SHADER, "step03_shader_points/flake.vert"},
                    {GL_FRAGMENT_SHADER, "step03_shader_points/flake_disc.frag"}});
    Program billboard({{GL_VERTEX_SHADER, "step06_accumulation/flake.vert"},
                       {GL_GEOMETRY_SHADER, "step06_accumulation/flake.geom"},
                       {GL_FRAGMENT_SHADER, "step06_accumulation/flake.frag"}});
    glActiveTexture(GL_TEXTURE6);  // which is the crystals' in all that follows
    const GlObject crystals = load_texture("step03_shader_points/snowflakes.png");
    glActiveTexture(GL_TEXTURE0);

    const vec3 sky(0.30f, 0.34f, 0.42f);
    glEnable(GL_DEPTH_TEST);
    glEnable(GL_PROGRAM_POINT_SIZE);  // the size comes from the vertex shader
    glEnable(GL_POINT_SPRITE);        // and gl_PointCoord with it
    glBlendFunc(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA);
    glClearColor(sky.r, sky.g, sky.b, 1.0f);
    while (window.begin_frame()) {
        if (window.weather_changed()) weather_block = upload_weather(weather);
        frame_rate.frame(window.frame_seconds(), window.steps(), options.setting("hold_fps"),
                         options.setting("live"));
        window.note(frame_rate.report());
        live.resize(frame_rate.share(), buffers[now], buffers[1 - now]);
        {
            const auto stage = window.stage("update");
            update.use();
            set_voxels(update, solid.grid, solid.voxels);
            world.wind.set(update, options);
            update.set("flake_mass", cover.flake_mass(weather) * live.weight());
            for (int n = 0; n < window.steps(); ++n, ++step) {
                update.set("step_number", step);
                glEnable(GL_RASTERIZER_DISCARD);  // vertices are computed, nothing is drawn
                glBindVertexArray(vaos[now]);
                for (const Range& half : live) {
                    if (half.count == 0) continue;  // an empty range may not be bound
                    glBindBufferRange(GL_TRANSFORM_FEEDBACK_BUFFER, 0, buffers[1 - now],
                                      begin_of(half), size_of(half));
                    glBeginTransformFeedback(GL_POINTS);
                    glDrawArrays(GL_POINTS, half.first, half.count);
                    glEndTransformFeedback();
                }
                glDisable(GL_RASTERIZER_DISCARD);
                glMemoryBarrier(GL_SHADER_STORAGE_BARRIER_BIT);  // who reads next sees this snow
                now = 1 - now;
            }
        }
        if (options.on("settling")) {
            const auto stage = window.stage("settle");
            for (int n = window.steps(); n > 0; --n) columns.settle(step - uint(n), solid);
        }
        if (options.on("melting")) {
            const auto stage = window.stage("melt");
            for (int n = window.steps(); n > 0; --n) columns.melt(step - uint(n), solid, weather);
        }
        {
            const auto stage = window.stage("depth");
            for (int n = window.steps(); n > 0; --n) columns.measure(step - uint(n), solid);
        }
        frame.update(window, step);
        lighting.update(options, step);
        if (options.on("shadow")) {
            const auto stage = window.stage("shadow");
            shadow_map.update(lighting.light(), solid.mesh, window.size());
        }
        {
            const auto stage = window.stage("scene");
            surface.draw(options.on("tessellation"), [&](Program& program) {
                set_voxels(program, solid.grid, solid.voxels);
                columns.set_depth(program);
                program.set("sparkle", options.on("sparkle") ? 1 : 0);
            });
        }
        if (options.on("sky")) {
            const auto stage = window.stage("sky");
            backdrop.use();
            glDepthRange(1, 1);  // as far as can be: it is seen where nothing else was drawn
            glDepthFunc(GL_LEQUAL);
            glDrawArrays(GL_TRIANGLES, 0, 3);
            glDepthFunc(GL_LESS);
            glDepthRange(0, 1);
        }
        if (options.on("lamp")) {
            const auto stage = window.stage("lamp");
            lamp.draw(lighting.light());
        }
        if (options.on("arrows")) {
            const auto stage = window.stage("arrows");
            arrows.draw(world.wind, solid, options, step);
        }
        {
            const auto stage = window.stage("draw");
            if (options.on("billboards")) {
                billboard.use();
                billboard.set("splashes", options.on("splashes") ? 1 : 0);
            } else {
                sprite.use();
                sprite.set("view", window.view());
                sprite.set("projection", window.projection());
                sprite.set("window_height", float(window.size().y));
            }
            glBindVertexArray(vaos[now]);
            glEnable(GL_BLEND);
            glDepthMask(GL_FALSE);  // flakes hide behind the scene, not behind each other
            for (const Range& half : live) glDrawArrays(GL_POINTS, half.first, half.count);
            glDepthMask(GL_TRUE);
            glDisable(GL_BLEND);
        }
    }
    glBindBuffer(GL_ARRAY_BUFFER, buffers[now]);
    glGetBufferSubData(GL_ARRAY_BUFFER, 0, GLsizeiptr(flakes.size() * sizeof(Particle)),
                       flakes.data());
    dump_flakes(options.dump, flakes);
    const std::vector<GLuint> mass = cover.read();
    ledger.print(flakes);
    cover.print(mass);
    dump_cover(options.dump_cover, solid.grid, mass);
}

int main(int argc, char** argv)
{
    return run_step(argc, argv, this_step, run);
}
