#include "common/gl_object.hpp"

#include <cstdio>
#include <stdexcept>

[[noreturn]] static void fail(const char* format, const char* what, unsigned number)
{
    char line[160];
    std::snprintf(line, sizeof line, format, what, number);
    throw std::runtime_error(line);
}

void check_memory(const char* what, double bytes)
{
    const GLenum error = glGetError();
    if (error == GL_OUT_OF_MEMORY)
        fail("not enough memory: %s need %u MiB (try fewer --particles or --voxels)", what,
             unsigned(bytes / (1 << 20)));
    if (error != GL_NO_ERROR) fail("%s: OpenGL error 0x%04X", what, error);
}

void check_framebuffer(const char* what)
{
    const GLenum status = glCheckFramebufferStatus(GL_FRAMEBUFFER);
    if (status != GL_FRAMEBUFFER_COMPLETE)
        fail("this card cannot draw %s: framebuffer status 0x%04X", what, status);
}

void check_read_back(const char* what)
{
    const GLenum error = glGetError();
    // A context that is lost answers nothing, and its calls do nothing: it has not even an error.
    if (glGetString(GL_VERSION) == nullptr || error != GL_NO_ERROR)
        fail("cannot read back %s: OpenGL error 0x%04X (is the context lost?)", what, error);
}
