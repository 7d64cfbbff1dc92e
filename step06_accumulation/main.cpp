// Step 6: same as step 5, but the snow stays: a flake that has lain for its time adds its mass to
// the cell it lies in, in a buffer that every shader may read and write. A full cell is solid to
// the flakes that follow, and the scene is drawn lifted and whitened by the snow upon it. New
// calls: GL_SHADER_STORAGE_BUFFER, glMemoryBarrier, and atomicAdd in the shader.

#include <GL/glew.h>

#include "common/options.hpp"
#include "common/output.hpp"
#include "common/program.hpp"
#include "common/scene.hpp"
#include "common/window.hpp"
#include "step03_shader_points/particle_layout.hpp"
#include "step05_collision/ledger.hpp"
#include "step05_collision/scene_collider.hpp"
#include "step06_accumulation/columns.hpp"
#include "step06_accumulation/snow_cover.hpp"
#include "step06_accumulation/wind_field.hpp"

using namespace snow;

const Step this_step = {
    .name = "step06_accumulation",
    .idea = "the snow of step 5, piling up on the scene: the full system",
    .least_gl = 4.3,
    .variants = {"cells"},
    .has_scene = true,
    .has_cover = true,
};

// From the first flake to the last frame, or until the panel asks for other flakes.
void run(Window& window)
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

    const Scene scene = load_scene(options.scene, options.up);
    const SceneMesh mesh(scene);
    const VoxelGrid grid = voxelise(scene, options.voxels);
    const GlObject voxels = upload_voxels(grid);
    const WindField wind(grid);
    SnowCover cover(grid);
    Columns columns(grid);
    const Ledger ledger;

    GlObject weather_block = upload_weather(weather);
    Program update({{GL_VERTEX_SHADER, "step06_accumulation/update.vert"}},
                   {"position", "age", "velocity", "rest"});
    Program backdrop({{GL_VERTEX_SHADER, "step04_transform_feedback/full_screen.vert"},
                      {GL_FRAGMENT_SHADER, "step06_accumulation/sky.frag"}});
    Program surface({{GL_VERTEX_SHADER, "step06_accumulation/scene.vert"},
                     {GL_FRAGMENT_SHADER, "step06_accumulation/scene.frag"}});
    Program flake({{GL_VERTEX_SHADER, "step03_shader_points/flake.vert"},
                   {GL_FRAGMENT_SHADER, "step03_shader_points/flake_disc.frag"}});

    const vec3 sky(0.30f, 0.34f, 0.42f);
    glEnable(GL_DEPTH_TEST);
    glEnable(GL_PROGRAM_POINT_SIZE);  // the size comes from the vertex shader
    glEnable(GL_POINT_SPRITE);        // and gl_PointCoord with it
    glBlendFunc(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA);
    glClearColor(sky.r, sky.g, sky.b, 1.0f);
    while (window.begin_frame()) {
        if (window.weather_changed()) weather_block = upload_weather(weather);
        {
            const auto stage = window.stage("update");
            update.use();
            set_voxels(update, grid, voxels);
            wind.set(update);
            update.set("flake_mass", cover.flake_mass(weather));
            for (int n = 0; n < window.steps(); ++n, ++step) {
                update.set("step_number", step);
                glEnable(GL_RASTERIZER_DISCARD);  // vertices are computed, nothing is drawn
                glBindVertexArray(vaos[now]);
                glBindBufferBase(GL_TRANSFORM_FEEDBACK_BUFFER, 0, buffers[1 - now]);
                glBeginTransformFeedback(GL_POINTS);
                glDrawArrays(GL_POINTS, 0, GLsizei(flakes.size()));
                glEndTransformFeedback();
                glDisable(GL_RASTERIZER_DISCARD);
                glMemoryBarrier(GL_SHADER_STORAGE_BARRIER_BIT);  // who reads next sees this snow
                now = 1 - now;
            }
        }
        {
            const auto stage = window.stage("accumulate");
            for (uint done = step - uint(window.steps()); done < step; ++done) {
                columns.update(done, grid, voxels, weather);
            }
        }
        {
            const auto stage = window.stage("sky");
            backdrop.use();
            backdrop.set("to_world", inverse(window.projection() * window.view()));
            backdrop.set("window_size", window.size());
            backdrop.set("field_depth", float(step) * weather.time_step * weather.snowfall / 60.0f);
            backdrop.set("eye", window.eye());
            backdrop.set("fog", sky);
            glDepthMask(GL_FALSE);  // everything else is nearer
            glDrawArrays(GL_TRIANGLES, 0, 3);
            glDepthMask(GL_TRUE);
        }
        {
            const auto stage = window.stage("scene");
            surface.use();
            set_voxels(surface, grid, voxels);
            surface.set("view", window.view());
            surface.set("projection", window.projection());
            surface.set("eye", window.eye());
            surface.set("fog", sky);
            mesh.draw();
        }
        {
            const auto stage = window.stage("draw");
            flake.use();
            flake.set("view", window.view());
            flake.set("projection", window.projection());
            flake.set("window_height", float(window.size().y));
            glBindVertexArray(vaos[now]);
            glEnable(GL_BLEND);
            glDepthMask(GL_FALSE);  // flakes hide behind the scene, not behind each other
            glDrawArrays(GL_POINTS, 0, GLsizei(flakes.size()));
            glDepthMask(GL_TRUE);
            glDisable(GL_BLEND);
        }
    }
    glBindBuffer(GL_ARRAY_BUFFER, buffers[now]);
    glGetBufferSubData(GL_ARRAY_BUFFER, 0, GLsizeiptr(flakes.size() * sizeof(Particle)),
                       flakes.data());
    dump_flakes(options.dump, flakes);
    const std::vector<GLuint> mass = cover.read();
    cover.print(mass, columns.melted(), ledger.print(flakes));
    dump_cover(options.dump_cover, grid, mass);
}

int main(int argc, char** argv)
{
    return run_step(argc, argv, this_step, run);
}
