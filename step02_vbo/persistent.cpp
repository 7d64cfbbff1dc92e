// The variant "persistent": same as main.cpp, but the flakes are copied straight into memory that
// the GPU reads, without a call. Nobody waits for us there any more, so we wait, at a fence.

#include <GL/glew.h>

#include <cstring>
#include <stdexcept>

#include "common/gl_object.hpp"
#include "common/window.hpp"
#include "step01_cpu_points/ground.hpp"
#include "step01_cpu_points/groups.hpp"
#include "step01_cpu_points/update.hpp"

using namespace snow;

void run_persistent(Window& window)
{
    const Options& options = window.options();
    const Weather& weather = options.weather;
    if (!GLEW_ARB_buffer_storage) {
        throw std::runtime_error("--variant persistent needs OpenGL 4.4: try orphan");
    }

    std::vector<Particle> flakes = make_flakes(weather);
    uint tick = 0;                                           // time steps made so far
    const std::vector<Group> groups = make_groups(options);  // flakes of one size
    const GLsizeiptr bytes = GLsizeiptr(flakes.size() * sizeof(Particle));
    // Room for three frames: while the GPU draws from one region, and the driver has another in its
    // queue, the third is written.
    constexpr int regions = 3;
    const GLsizeiptr all = max(regions * bytes, GLsizeiptr(1));  // none may be empty
    constexpr GLbitfield access = GL_MAP_WRITE_BIT | GL_MAP_PERSISTENT_BIT | GL_MAP_COHERENT_BIT;
    const GlObject buffer = make_buffer();
    glBindBuffer(GL_ARRAY_BUFFER, buffer);
    glBufferStorage(GL_ARRAY_BUFFER, all, nullptr, access);
    char* const mapped = static_cast<char*>(glMapBufferRange(GL_ARRAY_BUFFER, 0, all, access));
    if (mapped == nullptr)
        throw std::runtime_error("--variant persistent: the buffer cannot be mapped: try orphan");
    int region = 0;
    GLsync fences[regions] = {};  // each behind the last draw from its region

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
            region = (region + 1) % regions;
            if (fences[region] != nullptr) {
                glClientWaitSync(fences[region], GL_SYNC_FLUSH_COMMANDS_BIT, GL_TIMEOUT_IGNORED);
                glDeleteSync(fences[region]);
            }
            if (bytes > 0) std::memcpy(mapped + region * bytes, flakes.data(), size_t(bytes));
        }
        {
            const auto stage = window.stage("draw");
            load_matrices(window);
            // Positions lie sizeof(Particle) bytes apart in the buffer that is bound.
            glBindBuffer(GL_ARRAY_BUFFER, buffer);
            glEnableClientState(GL_VERTEX_ARRAY);
            glVertexPointer(3, GL_FLOAT, sizeof(Particle), nullptr);
            for (const Group& group : groups) {
                glPointSize(group.point_size);
                glDrawArrays(GL_POINTS, GLint(region * flakes.size() + group.begin),
                             GLsizei(group.end - group.begin));
            }
            fences[region] = glFenceSync(GL_SYNC_GPU_COMMANDS_COMPLETE, 0);
        }
        window.swap_buffers();
    }
    for (const GLsync fence : fences) glDeleteSync(fence);  // which ignores null
    window.dump(flakes);
}
