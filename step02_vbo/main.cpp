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

int main(int argc, char** argv)
try {
    const Options options = parse_options(
        argc, argv,
        {.name = "step02_vbo",
         .idea = "the snow of step 1, uploaded to a vertex buffer and drawn with one call",
         .least_gl = 1.5,
         .variants = {"subdata", "orphan", "persistent"}});
    Window window(options);
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
        {  // update
            for (int n = 0; n < window.steps(); ++n) update_in_one_loop(flakes, step++, weather);
        }
        {  // upload
            first_flake = buffer.upload(flakes);
        }
        {  // draw
            glMatrixMode(GL_PROJECTION);
            glLoadMatrixf(value_ptr(window.projection()));
            glMatrixMode(GL_MODELVIEW);
            glLoadMatrixf(value_ptr(window.view()));
            // Positions lie sizeof(Particle) bytes apart in the buffer that is bound.
            glEnableClientState(GL_VERTEX_ARRAY);
            glVertexPointer(3, GL_FLOAT, sizeof(Particle), nullptr);
            // The first half of the pool is emitter 0's: small flakes of 1 pixel; emitter 1's
            // have 2.
            const GLint middle = GLint(weather.particles / 2);
            glPointSize(1);
            glDrawArrays(GL_POINTS, first_flake, middle);
            glPointSize(2);
            glDrawArrays(GL_POINTS, first_flake + middle, GLsizei(flakes.size()) - middle);
            buffer.drawn();
        }
    }
    dump_flakes(options.dump, flakes);
    return 0;
} catch (const std::exception& failure) {
    return report_failure(failure);
}
