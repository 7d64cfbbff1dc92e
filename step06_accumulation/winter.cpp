// The variant "winter": same as main.cpp, but the full system. The wind flows around the scene, the
// snow is lit, shaded and as smooth as it needs to be, flakes are crystals, drops or hailstones,
// and fewer of them move where frames take too long. Each pass says what it reads and writes.

#include <GL/glew.h>

#include "common/program.hpp"
#include "common/uniform_block.hpp"
#include "common/window.hpp"
#include "step03_shader_points/load_texture.hpp"
#include "step04_transform_feedback/no_vertices.hpp"
#include "step04_transform_feedback/particle_buffer.hpp"
#include "step05_collision/ledger.hpp"
#include "step05_collision/solid_scene.hpp"
#include "step06_accumulation/cover/columns.hpp"
#include "step06_accumulation/cover/snow_cover.hpp"
#include "step06_accumulation/winter/flake_budget.hpp"
#include "step06_accumulation/winter/flakes/depth_order.hpp"
#include "step06_accumulation/winter/frame_block.hpp"
#include "step06_accumulation/winter/light/shadow_map.hpp"
#include "step06_accumulation/winter/light/sky_visibility.hpp"
#include "step06_accumulation/winter/permutations.hpp"
#include "step06_accumulation/winter/post/hdr_target.hpp"
#include "step06_accumulation/winter/surface/grain.hpp"
#include "step06_accumulation/winter/surface/snow_surface.hpp"
#include "step06_accumulation/winter/wind/wind_field.hpp"

using namespace snow;

namespace {

struct Programs {
    Permutations update{{{GL_COMPUTE_SHADER, "step06_accumulation/winter/wind/update.comp"}},
                        WIND_FIELD};
    Program smooth{{{GL_COMPUTE_SHADER, "step06_accumulation/winter/surface/smooth.comp"}}};
    Program sky{{{GL_VERTEX_SHADER, "step06_accumulation/winter/light/sky.vert"},
                 {GL_FRAGMENT_SHADER, "step06_accumulation/winter/light/sky.frag"}}};
    Permutations flake{{{GL_VERTEX_SHADER, "step06_accumulation/winter/flakes/flake.vert"},
                        {GL_GEOMETRY_SHADER, "step06_accumulation/winter/flakes/flake.geom"},
                        {GL_FRAGMENT_SHADER, "step06_accumulation/winter/flakes/flake.frag"}},
                       SHADOW | OCCLUSION | LAMP | BLUR};
    Permutations splash{{{GL_VERTEX_SHADER, "step06_accumulation/winter/flakes/flake.vert"},
                         {GL_GEOMETRY_SHADER, "step06_accumulation/winter/flakes/splash.geom"},
                         {GL_FRAGMENT_SHADER, "step06_accumulation/winter/flakes/flake.frag"}},
                        SHADOW | OCCLUSION | LAMP | BLUR};
    Program sprite{{{GL_VERTEX_SHADER, "step03_shader_points/flake.vert"},
                    {GL_FRAGMENT_SHADER, "step03_shader_points/flake.frag"}}};
    Permutations tone{{{GL_VERTEX_SHADER, "step04_transform_feedback/full_screen.vert"},
                       {GL_FRAGMENT_SHADER, "step06_accumulation/winter/post/tone.frag"}},
                      BLOOM};
};

}  // namespace

void run_winter(Window& window, const SolidScene& solid, const Settings& settings)
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
    FrameBlock frame_block(solid);
    FlakeBudget budget;
    WindField wind(solid.grid);
    DepthOrder depth_order(weather.particles);
    SnowSurface surface(solid);
    ShadowMap shadow_map;
    HdrTarget hdr_target;
    const GlObject snow_look = make_volume(GL_RGBA8, options.voxels),
                   sky_visibility = make_sky_visibility(solid.grid), grain = make_grain(),
                   crystals = load_texture("step03_shader_points/snowflakes.png");
    const NoVertices no_vertices;  // of the sky and the whole screen, which shaders know
    Programs programs;

    glEnable(GL_DEPTH_TEST);
    glEnable(GL_PROGRAM_POINT_SIZE);  // the size comes from the vertex shader
    glEnable(GL_POINT_SPRITE);        // and gl_PointCoord with it
    glBlendFunc(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA);
    while (window.begin_frame()) {
        weather_block.update(WEATHER_BLOCK, weather);
        const unsigned features = features_of(settings, weather);
        const LiveFlakes live(weather.particles, budget.share());
        {  // reads voxels and wind; changes flakes, cover and ledger
            const auto stage = window.stage("update");
            Program& update = programs.update.use(features);
            if (settings.wind_field) wind.bind(weather.wind);
            solid.bind();
            ledger.bind();
            cover.bind();
            live.set(update);
            update.set("gusts", settings.gusts);
            update.set("flake_mass", cover.flake_mass(weather, solid.grid) * live.weight());
            for (; window.next_tick(); ++tick) {
                update.set("tick", tick);
                glMemoryBarrier(GL_SHADER_STORAGE_BARRIER_BIT);  // what came before is done
                particles.dispatch(update);
            }
            glMemoryBarrier(GL_VERTEX_ATTRIB_ARRAY_BARRIER_BIT);  // the draw reads the flakes
        }
        budget.frame(window.frame_seconds(), window.ticks(), settings.hold_fps, settings.live);
        window.note(budget.report());
        if (settings.cover.settling) {  // changes the cover
            const auto stage = window.stage("settle");
            columns.settle(tick, window.ticks());
        }
        if (settings.cover.melting) {  // changes the cover
            const auto stage = window.stage("melt");
            columns.melt(tick, window.ticks(), weather);
        }
        {  // reads the cover; writes how deep it is
            const auto stage = window.stage("depth");
            columns.measure(tick, window.ticks());
        }
        {  // reads how deep the cover is; writes what it looks like
            const auto stage = window.stage("smooth");
            glBindImageTexture(DEPTH_IMAGE, columns.depth(), 0, GL_TRUE, 0, GL_READ_ONLY, GL_RG16F);
            glBindImageTexture(SNOW_IMAGE, snow_look, 0, GL_TRUE, 0, GL_WRITE_ONLY, GL_RGBA8);
            columns.dispatch(programs.smooth, tick, window.ticks());
        }
        const Frame& frame = frame_block.update(window, settings, tick);
        if (settings.shadow) {  // reads the scene; writes the shadow map, if the sun has moved
            const auto stage = window.stage("shadow");
            shadow_map.update(frame.to_sun, solid, settings.soft_shadows,
                              settings.soft_shadows || options.metres);
        }
        glViewport(0, 0, window.size().x, window.size().y);
        hdr_target.begin(window.size(), settings.multisample, vec3(0.10f, 0.13f, 0.20f));
        solid.bind();
        bind_texture(SHADOW_UNIT, GL_TEXTURE_2D, shadow_map.texture());
        bind_texture(SKY_VISIBILITY_UNIT, GL_TEXTURE_3D, sky_visibility);
        bind_texture(DEPTH_UNIT, GL_TEXTURE_3D, columns.depth());
        bind_texture(SNOW_UNIT, GL_TEXTURE_3D, snow_look);
        bind_texture(GRAIN_UNIT, GL_TEXTURE_2D, grain);
        bind_texture(CRYSTALS_UNIT, GL_TEXTURE_2D, crystals);
        if (settings.scene) {  // reads snow, shadow map and sky's visibility; draws the surface
            const auto stage = window.stage("scene");
            surface.draw(features, settings.tessellation);
        }
        if (settings.sky) {  // draws the sky where nothing else is
            const auto stage = window.stage("sky");
            programs.sky.use();
            glBindVertexArray(no_vertices);
            glDepthFunc(GL_LEQUAL);                      // it is as far as can be
            glDrawArrays(GL_TRIANGLES, 0, 6 * 40 * 24);  // squares: see sky.vert
            glDepthFunc(GL_LESS);
        }
        if (settings.arrows) {  // reads the wind; draws arrows
            const auto stage = window.stage("arrows");
            wind.draw_arrows(weather.wind, window.view(), window.projection());
        }
        hdr_target.resolve();
        if (settings.sorted) {  // reads the flakes; writes their order
            const auto stage = window.stage("sort");
            depth_order.sort(particles, live);
        }
        {  // reads flakes, shadow map and sky's visibility; blends over the surface
            const auto stage = window.stage("draw");
            glBindVertexArray(particles.vao());
            glEnable(GL_BLEND);
            glDepthMask(GL_FALSE);  // flakes hide behind the scene, not behind each other
            if (settings.billboards) {
                programs.flake.use(features).set("around", 1);
                if (settings.around) live.draw_around();
                programs.flake.use(features).set("around", 0);
            } else {
                programs.sprite.use();
                programs.sprite.set("view", window.view());
                programs.sprite.set("projection", window.projection());
                programs.sprite.set("window_height", float(window.size().y));
            }
            settings.sorted ? depth_order.draw() : live.draw();
            if (settings.billboards && settings.splashes && weather.kind == rain_kind) {
                programs.splash.use(features);
                live.draw();
            }
            glDepthMask(GL_TRUE);
            glDisable(GL_BLEND);
        }
        bind_texture(FRAME_UNIT, GL_TEXTURE_2D, hdr_target.colour());
        if (settings.bloom > 0) {  // reads the frame; writes its mipmaps
            const auto stage = window.stage("bloom");
            glGenerateMipmap(GL_TEXTURE_2D);
        }
        {  // reads the frame; draws colours into the window
            const auto stage = window.stage("tone");
            glBindFramebuffer(GL_FRAMEBUFFER, 0);
            glDisable(GL_DEPTH_TEST);
            programs.tone.use(features);
            glBindVertexArray(no_vertices);
            glDrawArrays(GL_TRIANGLES, 0, 3);
            glEnable(GL_DEPTH_TEST);
        }
        window.swap_buffers();
    }
    particles.read(flakes);
    window.dump(flakes);
    ledger.print(flakes);
    cover.report(solid.grid, options.dump_cover);
}
