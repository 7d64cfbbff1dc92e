// Step 4: same as step 3, but the update runs on the GPU as well: a vertex shader moves each flake,
// and transform feedback writes the result to a second buffer; then the two change roles. After the
// start no flake ever crosses the bus again, so the upload is gone. New calls:
// glTransformFeedbackVaryings (in common/program.cpp), glBeginTransformFeedback, glBindBufferBase,
// glEnable(GL_RASTERIZER_DISCARD).

#include <GL/glew.h>

#include <optional>

#include "common/options.hpp"
#include "common/output.hpp"
#include "common/program.hpp"
#include "common/window.hpp"
#include "step03_shader_points/particle_layout.hpp"
#include "step04_transform_feedback/flakes_in_textures.hpp"

using namespace snow;

const Step this_step = {
    .name = "step04_transform_feedback",
    .idea = "the snow of step 3, moved by the GPU as well as drawn by it",
    .least_gl = 3.3,
    .variants = {"feedback", "texture"},
};

// From the first flake to the last frame, or until the panel asks for other flakes.
void run(Window& window)
{
    const Options& options = window.options();
    const Weather& weather = options.weather;

    std::vector<Particle> flakes = make_flakes(weather);
    uint step = 0;
    std::optional<FlakesInTextures> textures;  // instead of the buffers, in the variant "texture"
    if (options.variant == "texture") textures.emplace(flakes);
    // Ping-pong: an update reads one buffer and writes the other; it may not do both to the same.
    GlObject buffers[2], vaos[2];
    for (int i = 0; i < 2 && !textures; ++i) {
        buffers[i] = make_buffer();
        vaos[i] = make_vertex_array();
        glBindVertexArray(vaos[i]);
        glBindBuffer(GL_ARRAY_BUFFER, buffers[i]);
        glBufferData(GL_ARRAY_BUFFER, GLsizeiptr(flakes.size() * sizeof(Particle)), flakes.data(),
                     GL_DYNAMIC_COPY);
        describe_particles();
    }
    int now = 0;  // the buffer that holds the flakes as they are

    GlObject weather_block = upload_weather(weather);
    Program update({{GL_VERTEX_SHADER, "step04_transform_feedback/update.vert"}},
                   {"position", "age", "velocity", "rest"});
    Program flake({{GL_VERTEX_SHADER, textures ? "step04_transform_feedback/flake_texture.vert"
                                               : "step03_shader_points/flake.vert"},
                   {GL_FRAGMENT_SHADER, "step03_shader_points/flake_disc.frag"}});

    glEnable(GL_PROGRAM_POINT_SIZE);  // the size comes from the vertex shader
    glEnable(GL_POINT_SPRITE);        // and gl_PointCoord with it
    glBlendFunc(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA);
    glClearColor(0.13f, 0.09f, 0.08f, 1.0f);
    while (window.begin_frame()) {
        if (window.weather_changed()) weather_block = upload_weather(weather);
        {
            const auto stage = window.stage("update");
            for (int n = 0; n < window.steps(); ++n, ++step) {
                if (textures) {
                    textures->update(step);
                    continue;
                }
                update.use();
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
            const auto stage = window.stage("draw");
            flake.use();
            flake.set("view", window.view());
            flake.set("projection", window.projection());
            flake.set("window_height", float(window.size().y));
            if (textures) textures->bind(flake);
            glBindVertexArray(vaos[now]);
            glEnable(GL_BLEND);
            glDrawArrays(GL_POINTS, 0, GLsizei(flakes.size()));
            glDisable(GL_BLEND);
        }
    }
    if (textures) {
        textures->read(flakes);
    } else {
        glBindBuffer(GL_ARRAY_BUFFER, buffers[now]);
        glGetBufferSubData(GL_ARRAY_BUFFER, 0, GLsizeiptr(flakes.size() * sizeof(Particle)),
                           flakes.data());
    }
    dump_flakes(options.dump, flakes);
}

int main(int argc, char** argv)
{
    return run_step(argc, argv, this_step, run);
}
