#include "common/gl_object.hpp"

#include <cstdio>
#include <stdexcept>

void check_memory(const char* what, double bytes)
{
    const GLenum error = glGetError();
    if (error == GL_NO_ERROR) return;
    char line[160];
    if (error == GL_OUT_OF_MEMORY) {
        std::snprintf(line, sizeof line,
                      "not enough memory: %s need %.0f MiB (try fewer --particles or --voxels)",
                      what, bytes / (1 << 20));
    } else {
        std::snprintf(line, sizeof line, "OpenGL error 0x%04X up to %s", error, what);
    }
    throw std::runtime_error(line);
}

void check_framebuffer(const char* what)
{
    const GLenum status = glCheckFramebufferStatus(GL_FRAMEBUFFER);
    if (status == GL_FRAMEBUFFER_COMPLETE) return;
    char line[160];
    std::snprintf(line, sizeof line, "this card cannot draw %s: framebuffer status 0x%04X", what,
                  status);
    throw std::runtime_error(line);
}

// A context that is lost answers nothing, and its calls do nothing: it has not even an error.
void check_read_back(const char* what)
{
    const GLenum error = glGetError();
    const bool lost = glGetString(GL_VERSION) == nullptr;
    if (!lost && error == GL_NO_ERROR) return;
    char line[160];
    std::snprintf(line, sizeof line, "cannot read back %s: %s 0x%04X", what,
                  lost ? "the context is lost, error" : "OpenGL error", error);
    throw std::runtime_error(line);
}
