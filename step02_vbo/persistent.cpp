// The variant "persistent": same as main.cpp, but the flakes are copied straight into memory that
// the GPU reads, without a call. Nobody waits for us there any more, so we wait, at a fence. New
// calls: glBufferStorage, glMapBufferRange, glFenceSync, glClientWaitSync.

#include <GL/glew.h>

#include <cstring>
#include <glm/gtc/type_ptr.hpp>
#include <stdexcept>

#include "common/gl_object.hpp"
#include "common/harness/driver.hpp"
#include "common/window.hpp"
#include "step01_cpu_points/ground.hpp"
#include "step01_cpu_points/update.hpp"

using namespace snow;

void run_persistent(Window& window)
{
    const Options& options = window.options();
    const Weather& weather = options.weather;
    if (!has_extension("GL_ARB_buffer_storage")) {
        throw std::runtime_error("--variant persistent needs OpenGL 4.4: try orphan");
    }

    std::vector<Particle> flakes = make_flakes(weather);
    uint tick = 0;  // time steps made so far
    const GLsizeiptr bytes = GLsizeiptr(flakes.size() * sizeof(Particle));
    // Room for three frames: while the GPU draws from one part, and the driver has another in its
    // queue, the third is written.
    constexpr int parts = 3;
    const GLsizeiptr all = max(parts * bytes, GLsizeiptr(1));  // none may be empty
    constexpr GLbitfield access = GL_MAP_WRITE_BIT | GL_MAP_PERSISTENT_BIT | GL_MAP_COHERENT_BIT;
    const GlObject buffer = make_buffer();
    glBindBuffer(GL_ARRAY_BUFFER, buffer);
    glBufferStorage(GL_ARRAY_BUFFER, all, nullptr, access);
    char* const mapped = static_cast<char*>(glMapBufferRange(GL_ARRAY_BUFFER, 0, all, access));
    if (mapped == nullptr)
        throw std::runtime_error("--variant persistent: the buffer cannot be mapped: try orphan");
    int part = 0;
    GLsync fences[parts] = {};  // each behind the last draw from its part

    glClearColor(0.05f, 0.10f, 0.10f, 1.0f);
    while (window.begin_frame()) {
        glViewport(0, 0, window.size().x, window.size().y);
        glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
        draw_ground(window);
        {
            const auto stage = window.stage("update");
            while (window.next_tick()) update_in_one_loop(flakes, tick++, weather);
        }
        {
            const auto stage = window.stage("upload");
            part = (part + 1) % parts;
            if (fences[part] != nullptr) {
                glClientWaitSync(fences[part], GL_SYNC_FLUSH_COMMANDS_BIT, GL_TIMEOUT_IGNORED);
                glDeleteSync(fences[part]);
            }
            if (bytes > 0) std::memcpy(mapped + part * bytes, flakes.data(), size_t(bytes));
        }
        {
            const auto stage = window.stage("draw");
            glMatrixMode(GL_PROJECTION);
            glLoadMatrixf(value_ptr(window.projection()));
            glMatrixMode(GL_MODELVIEW);
            glLoadMatrixf(value_ptr(window.view()));
            // Positions lie sizeof(Particle) bytes apart in the buffer that is bound.
            glBindBuffer(GL_ARRAY_BUFFER, buffer);
            glEnableClientState(GL_VERTEX_ARRAY);
            glVertexPointer(3, GL_FLOAT, sizeof(Particle), nullptr);
            // In pieces, for points of two sizes: the first half of the pool is emitter 0's, of
            // small flakes, the second half emitter 1's.
            for (uint group = 0; group < options.groups; ++group) {
                const uint begin = options.group_begin(group), end = options.group_begin(group + 1);
                glPointSize(options.point_size * (of_first_emitter(begin, weather) ? 1.0f : 2.0f));
                glDrawArrays(GL_POINTS, GLint(part * flakes.size() + begin), GLsizei(end - begin));
            }
            fences[part] = glFenceSync(GL_SYNC_GPU_COMMANDS_COMPLETE, 0);
        }
        window.swap_buffers();
    }
    for (const GLsync fence : fences) glDeleteSync(fence);  // which ignores null
    window.dump(flakes);
}
