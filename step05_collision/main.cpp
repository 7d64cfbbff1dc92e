// Step 5: same as step 4, but there is a scene, and the snow lands on it. At the start the CPU
// divides space into voxels and marks those that the scene fills, one bit each; every frame each
// flake looks up the few voxels on its way. The cost is per flake, not per triangle. New calls:
// glTexImage3D, texelFetch and atomicCounterIncrement in the shader, glEnable(GL_DEPTH_TEST).

#include <GL/glew.h>

#include "common/options.hpp"
#include "common/output.hpp"
#include "common/program.hpp"
#include "common/window.hpp"
#include "step03_shader_points/particle_layout.hpp"
#include "step05_collision/ledger.hpp"
#include "step05_collision/scene_collider.hpp"
#include "step05_collision/solid_scene.hpp"

using namespace snow;

const Step this_step = {
    .name = "step05_collision",
    .idea = "the snow of step 4, landing on a scene that the GPU knows as voxels",
    .least_gl = 3.3,
    .variants = {"voxels", "triangles"},
    .has_scene = true,
    .extensions = {"GL_ARB_shader_atomic_counters"},
};

// From the first flake to the last frame, or until the panel asks for other flakes.
void run(Window& window, const SolidScene& solid)
{
    const Options& options = window.options();
    const Weather& weather = options.weather;
    const bool triangles = options.variant == "triangles";

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

    const TriangleTexture triangle_texture(triangles ? solid.scene : Scene{});
    const Ledger ledger;

    GlObject weather_block = upload_weather(weather);
    Program update({{GL_VERTEX_SHADER, triangles ? "step05_collision/update_triangles.vert"
                                                 : "step05_collision/update.vert"}},
                   {"position", "age", "velocity", "rest"});
    Program surface({{GL_VERTEX_SHADER, "step05_collision/scene.vert"},
                     {GL_FRAGMENT_SHADER, "step05_collision/scene.frag"}});
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
            if (triangles) {
                triangle_texture.set(update);
            } else {
                set_voxels(update, solid.grid, solid.voxels);
            }
            for (int n = 0; n < window.steps(); ++n, ++step) {
                update.set("step_number", step);
                glEnable(GL_RASTERIZER_DISCARD);  // vertices are computed, nothing is drawn
                glBindVertexArray(vaos[now]);
                glBindBufferBase(GL_TRANSFORM_FEEDBACK_BUFFER, 0, buffers[1 - now]);
                glBeginTransformFeedback(GL_POINTS);
                glDrawArrays(GL_POINTS, 0, GLsizei(flakes.size()));
                glEndTransformFeedback();
                glDisable(GL_RASTERIZER_DISCARD);
                now = 1 - now;
            }
        }
        {
            const auto stage = window.stage("scene");
            surface.use();
            surface.set("view", window.view());
            surface.set("projection", window.projection());
            surface.set("eye", window.eye());
            surface.set("fog", sky);
            solid.mesh.draw();
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
    ledger.print(flakes);
}

int main(int argc, char** argv)
{
    return run_step(argc, argv, this_step, run);
}
