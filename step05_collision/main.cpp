// Step 5: same as step 4, but there is a scene, and the snow lands on it. Voxels, one bit each,
// tell what it fills; every frame each flake looks up the few on its way. The cost is per flake,
// not per triangle. New calls: glTexImage3D, texelFetch and atomicCounterIncrement in the shader,
// glEnable(GL_DEPTH_TEST), glDrawElements (in scene_mesh.cpp).

#include <GL/glew.h>

#include "common/program.hpp"
#include "common/uniform_block.hpp"
#include "common/window.hpp"
#include "step04_transform_feedback/ping_pong.hpp"
#include "step05_collision/ledger.hpp"
#include "step05_collision/solid_scene.hpp"
#include "step05_collision/triangle_texture.hpp"

using namespace snow;

void run(Window& window, const SolidScene& solid)
{
    const Options& options = window.options();
    const Weather& weather = options.weather;
    const bool no_voxels = options.variant != "voxels";

    std::vector<Particle> flakes = make_flakes(weather);
    uint tick = 0;  // time steps made so far
    PingPong particles(flakes);
    const TriangleTexture triangles(no_voxels ? solid.obstacle() : Scene{},
                                    options.variant == "boxes");
    const Ledger ledger;

    UniformBlock<Weather> weather_block;
    Program update({{GL_VERTEX_SHADER, no_voxels ? "step05_collision/update_triangles.vert"
                                                 : "step05_collision/update.vert"}},
                   {"position", "age", "velocity", "rest"});
    Program surface({{GL_VERTEX_SHADER, "step05_collision/scene.vert"},
                     {GL_FRAGMENT_SHADER, "step05_collision/scene.frag"}});
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
            triangles.bind();
            ledger.bind();
            for (; window.next_tick(); ++tick) {
                update.set("tick", tick);
                glEnable(GL_RASTERIZER_DISCARD);  // vertices are computed, nothing is drawn
                glBindVertexArray(particles.vao());
                glBindBufferBase(GL_TRANSFORM_FEEDBACK_BUFFER, FEEDBACK_BUFFER, particles.target());
                glBeginTransformFeedback(GL_POINTS);
                glDrawArrays(GL_POINTS, 0, GLsizei(flakes.size()));
                glEndTransformFeedback();
                glDisable(GL_RASTERIZER_DISCARD);
                particles.swap();
            }
        }
        {
            const auto stage = window.stage("scene");
            surface.use();
            surface.set("view", window.view());
            surface.set("projection", window.projection());
            surface.set("eye", window.eye());
            surface.set("fog", sky);
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
}

int main(int argc, char** argv)
{
    // Reads the scene once, however often the snow begins anew.
    const auto load_and_run = [](Window& window) {
        const SolidScene solid(window);
        do {
            run(window, solid);
        } while (window.restarted());
    };
    Lesson lesson;
    lesson.name = "step05_collision";
    lesson.idea = "the snow of step 4, landing on a scene that the GPU knows as voxels";
    lesson.minimum_gl = 3.3;
    lesson.variants = {
        {"voxels", load_and_run}, {"triangles", load_and_run}, {"boxes", load_and_run}};
    lesson.has_scene = true;
    lesson.extensions = {"GL_ARB_shader_atomic_counters", "GL_ARB_shader_image_load_store",
                         "GL_ARB_shading_language_420pack"};
    lesson.limits = {{GL_MAX_VERTEX_ATOMIC_COUNTERS, 8, "atomic counters in vertex shaders"}};
    return run_lesson(argc, argv, lesson);
}
