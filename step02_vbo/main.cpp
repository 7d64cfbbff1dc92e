// Step 2: same as step 1, but the flakes travel to the GPU in one piece: one upload into a vertex
// buffer, one draw call for each size of point. The cost moves from 20,000 function calls to one
// copy. New calls: glBindBuffer, glBufferData, glBufferSubData, glVertexPointer, glDrawArrays (and
// glMapBufferRange).

#include <GL/glew.h>

#include <glm/gtc/type_ptr.hpp>

#include "common/options.hpp"
#include "common/output.hpp"
#include "common/window.hpp"
#include "step01_cpu_points/update.hpp"
#include "step02_vbo/stream_buffer.hpp"

using namespace snow;

const Step this_step = {
    .name = "step02_vbo",
    .idea = "the snow of step 1, uploaded to a vertex buffer and drawn with one call",
    .least_gl = 1.5,
    .variants = {"subdata", "orphan", "persistent"},
    .fixed_points = true,
};

// From the first flake to the last frame, or until the panel asks for other flakes.
void run(Window& window)
{
    const Options& options = window.options();
    const Weather& weather = options.weather;
    if (options.variant == "persistent" && !GLEW_ARB_buffer_storage) {
        throw std::runtime_error("--variant persistent needs OpenGL 4.4: try orphan");
    }

    std::vector<Particle> flakes = make_flakes(weather);
    uint step = 0;
    StreamBuffer buffer(options.variant, flakes.size());

    glClearColor(0.05f, 0.10f, 0.10f, 1.0f);
    while (window.begin_frame()) {
        GLint first_flake = 0;
        {
            const auto stage = window.stage("update");
            for (int n = 0; n < window.steps(); ++n) update_in_one_loop(flakes, step++, weather);
        }
        {
            const auto stage = window.stage("upload");
            first_flake = buffer.upload(flakes);
        }
        {
            const auto stage = window.stage("draw");
            glMatrixMode(GL_PROJECTION);
            glLoadMatrixf(value_ptr(window.projection()));
            glMatrixMode(GL_MODELVIEW);
            glLoadMatrixf(value_ptr(window.view()));
            // Positions lie sizeof(Particle) bytes apart in the buffer that is bound.
            glEnableClientState(GL_VERTEX_ARRAY);
            glVertexPointer(3, GL_FLOAT, sizeof(Particle), nullptr);
            // In pieces, for points of two sizes: the first half of the pool is emitter 0's, of
            // small flakes, the second half emitter 1's.
            for (uint group = 0; group < options.groups; ++group) {
                const uint begin = options.group_begin(group), end = options.group_begin(group + 1);
                glPointSize(options.point_size * (of_first_emitter(begin, weather) ? 1.0f : 2.0f));
                glDrawArrays(GL_POINTS, first_flake + GLint(begin), GLsizei(end - begin));
            }
            buffer.drawn();
        }
    }
    dump_flakes(options.dump, flakes);
}

int main(int argc, char** argv)
{
    return run_step(argc, argv, this_step, run);
}
