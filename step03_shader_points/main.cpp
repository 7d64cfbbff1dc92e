// Step 3: same as step 2, but shaders draw the flakes: a vertex shader makes each as large as it
// looks from its distance, a fragment shader gives the square point its shape. The cost of beauty
// is paid per pixel, on the GPU. New calls: glUseProgram, glVertexAttribPointer,
// glEnable(GL_PROGRAM_POINT_SIZE), glBlendFunc, glTexImage2D.

#include <GL/glew.h>

#include "common/options.hpp"
#include "common/output.hpp"
#include "common/program.hpp"
#include "common/texture.hpp"
#include "common/window.hpp"
#include "step01_cpu_points/update.hpp"
#include "step02_vbo/stream_buffer.hpp"
#include "step03_shader_points/particle_layout.hpp"

using namespace snow;

const Step this_step = {
    .name = "step03_shader_points",
    .idea = "the snow of step 2, drawn by shaders as point sprites that shrink with distance",
    .least_gl = 3.3,
    .variants = {"disc", "texture"},
};

// From the first flake to the last frame, or until the panel asks for other flakes.
void run(Window& window)
{
    const Options& options = window.options();
    const Weather& weather = options.weather;

    std::vector<Particle> flakes = make_flakes(weather);
    uint step = 0;
    StreamBuffer buffer("subdata", flakes.size());

    GlObject weather_block = upload_weather(weather);
    Program flake(
        {{GL_VERTEX_SHADER, "step03_shader_points/flake.vert"},
         {GL_FRAGMENT_SHADER, "step03_shader_points/flake_" + options.variant + ".frag"}});
    const GlObject crystals = load_texture("step03_shader_points/snowflakes.png");
    const GlObject vao = make_vertex_array();
    glBindVertexArray(vao);
    glBindBuffer(GL_ARRAY_BUFFER, buffer.name());
    describe_particles();

    glEnable(GL_PROGRAM_POINT_SIZE);  // the size comes from the vertex shader
    glEnable(GL_POINT_SPRITE);        // and gl_PointCoord with it
    glBlendFunc(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA);
    glClearColor(0.10f, 0.08f, 0.14f, 1.0f);
    while (window.begin_frame()) {
        if (window.weather_changed()) weather_block = upload_weather(weather);
        {
            const auto stage = window.stage("update");
            for (int n = 0; n < window.steps(); ++n) update_in_one_loop(flakes, step++, weather);
        }
        {
            const auto stage = window.stage("upload");
            buffer.upload(flakes);
        }
        {
            const auto stage = window.stage("draw");
            flake.use();
            flake.set("view", window.view());
            flake.set("projection", window.projection());
            flake.set("window_height", float(window.size().y));
            glBindVertexArray(vao);
            glEnable(GL_BLEND);
            glDrawArrays(GL_POINTS, 0, GLsizei(flakes.size()));
            glDisable(GL_BLEND);
        }
    }
    dump_flakes(options.dump, flakes);
}

int main(int argc, char** argv)
{
    return run_step(argc, argv, this_step, run);
}
