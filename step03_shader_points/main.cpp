// Step 3: same as step 2, but shaders draw the flakes: a vertex shader makes each as large as it
// looks from its distance, a fragment shader gives the square point its shape: a disc, or a crystal
// from a picture. The cost of beauty is paid sprite by sprite, on the GPU.

#include <GL/glew.h>

#include "common/program.hpp"
#include "common/uniform_block.hpp"
#include "common/window.hpp"
#include "step01_cpu_points/ground.hpp"
#include "step01_cpu_points/update.hpp"
#include "step03_shader_points/load_texture.hpp"
#include "step03_shader_points/particle_layout.hpp"

using namespace snow;

void run(Window& window)
{
    const Options& options = window.options();
    const Weather& weather = options.weather;
    const bool textured = options.variant == "texture";

    std::vector<Particle> flakes = make_flakes(weather);
    uint tick = 0;  // time steps made so far
    const GLsizeiptr bytes = GLsizeiptr(flakes.size() * sizeof(Particle));
    const GlObject buffer = make_buffer();
    const GlObject vao = make_vertex_array();
    glBindVertexArray(vao);
    glBindBuffer(GL_ARRAY_BUFFER, buffer);
    glBufferData(GL_ARRAY_BUFFER, bytes, nullptr, GL_STREAM_DRAW);
    check_memory("the flakes", double(bytes));
    describe_particles();

    UniformBlock<Weather> weather_block;
    Program flake({{GL_VERTEX_SHADER, "step03_shader_points/flake.vert"},
                   {GL_FRAGMENT_SHADER, textured ? "step03_shader_points/crystal.frag"
                                                 : "step03_shader_points/flake.frag"}});
    GlObject crystals;
    if (textured) crystals = load_texture("step03_shader_points/snowflakes.png");

    glEnable(GL_PROGRAM_POINT_SIZE);  // the size comes from the vertex shader
    glEnable(GL_POINT_SPRITE);        // and gl_PointCoord with it
    glBlendFunc(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA);
    glClearColor(0.10f, 0.08f, 0.14f, 1.0f);
    while (window.begin_frame()) {
        glViewport(0, 0, window.size().x, window.size().y);
        glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
        draw_ground(window);
        weather_block.update(WEATHER_BLOCK, weather);
        {
            const auto stage = window.stage("update");
            while (window.next_tick()) update_in_one_loop(flakes, tick++, weather);
        }
        {
            const auto stage = window.stage("upload");
            glBindBuffer(GL_ARRAY_BUFFER, buffer);
            glBufferSubData(GL_ARRAY_BUFFER, 0, bytes, flakes.data());
        }
        {
            const auto stage = window.stage("draw");
            flake.use();
            flake.set("view", window.view());
            flake.set("projection", window.projection());
            flake.set("window_height", float(window.size().y));
            if (textured) flake.set_texture("crystals", CRYSTALS_UNIT, GL_TEXTURE_2D, crystals);
            glBindVertexArray(vao);
            glEnable(GL_BLEND);
            glDrawArrays(GL_POINTS, 0, GLsizei(flakes.size()));
            glDisable(GL_BLEND);
        }
        window.swap_buffers();
    }
    window.dump(flakes);
}

int main(int argc, char** argv)
{
    Lesson lesson;
    lesson.name = "step03_shader_points";
    lesson.idea = "the snow of step 2, drawn by shaders as point sprites that shrink with distance";
    lesson.minimum_gl = 3.3;
    lesson.variants = {{"disc", run}, {"texture", run}};
    return run_lesson(argc, argv, lesson);
}
