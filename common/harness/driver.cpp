#include "common/harness/driver.hpp"

#include "common/gl_object.hpp"
#include "common/harness/text.hpp"

#include <GL/glew.h>
#include <GL/freeglut.h>

#include <csignal>
#include <cstdarg>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <iostream>
#include <stdexcept>

namespace {

const char* gl_string(GLenum name)
{
    return reinterpret_cast<const char*>(glGetString(name));
}

std::string renderer_of_context;  // as it was while there was a context to ask

volatile std::sig_atomic_t interrupt = 0;

void on_interrupt(int signal)
{
    interrupt = 1;
    std::signal(signal, SIG_DFL);
}

// Advice, such as on what makes it slow, goes to stdout: stderr is for what is wrong.
void GLAPIENTRY on_message(GLenum, GLenum type, GLuint, GLenum severity, GLsizei,
                           const GLchar* message, const void*)
{
    if (severity == GL_DEBUG_SEVERITY_NOTIFICATION) return;
    if (type == GL_DEBUG_TYPE_PERFORMANCE) {
        std::cout << "OpenGL performance: " << message << std::endl;
        return;
    }
    std::cerr << "OpenGL" << (severity == GL_DEBUG_SEVERITY_HIGH ? " (high severity): " : ": ")
              << message << "\n";
}

// freeglut cannot go on after an error, and must not return from this.
void on_glut_error(const char* format, va_list arguments)
{
    std::fputs("error: ", stderr);
    std::vfprintf(stderr, format, arguments);
#ifdef _WIN32
    std::fputs(" (has the display OpenGL? a remote one may have none)\n", stderr);
#else
    const bool no_display = std::strstr(format, "open display") != nullptr;
    std::fputs(no_display ? " (is DISPLAY set to a running X server? `xvfb-run` provides one "
                            "without a screen)\n"
                          : " (has the display OpenGL? `glxinfo -B` tells)\n",
               stderr);
#endif
    std::_Exit(1);
}

void on_glut_warning(const char*, va_list) {}

}  // namespace

void report_glut_errors()
{
    glutInitErrorFunc(on_glut_error);
    glutInitWarningFunc(on_glut_warning);
}

void catch_interrupts()
{
    std::signal(SIGINT, on_interrupt);
    std::signal(SIGTERM, on_interrupt);
}

bool interrupted()
{
    return interrupt != 0;
}

void load_opengl()
{
    glewExperimental = GL_TRUE;
    const GLenum status = glewInit();
    // Without a GLX display (under Wayland) GLEW has still loaded OpenGL's own functions.
    if (status != GLEW_OK && status != GLEW_ERROR_NO_GLX_DISPLAY) {
        throw std::runtime_error(std::string("cannot load OpenGL's functions: ") +
                                 reinterpret_cast<const char*>(glewGetErrorString(status)));
    }
    renderer_of_context = gl_string(GL_RENDERER);
}

// Not GLEW's own flags: with glewExperimental they say that there are pointers to the functions,
// which a driver may hand out for what it lacks.
bool has_extension(const char* name)
{
    if (!GLEW_VERSION_3_0) return glewGetExtension(name);
    GLint count = 0;
    glGetIntegerv(GL_NUM_EXTENSIONS, &count);
    for (GLint i = 0; i < count; ++i) {
        const GLubyte* extension = glGetStringi(GL_EXTENSIONS, GLuint(i));
        if (std::strcmp(reinterpret_cast<const char*>(extension), name) == 0) return true;
    }
    return false;
}

void check_opengl(const Lesson& lesson)
{
    // "4.5 (Compatibility Profile) Mesa ..."
    const double version = std::strtod(gl_string(GL_VERSION), nullptr);
    if (version < lesson.minimum_gl - 0.01) {
        char line[128];
        std::snprintf(line, sizeof line,
                      "%s needs OpenGL %.1f, this is %.1f (%s): try an earlier step",
                      lesson.name.c_str(), lesson.minimum_gl, version, gl_string(GL_RENDERER));
        throw std::runtime_error(line);
    }
    for (const char* extension : lesson.extensions) {
        if (!has_extension(extension)) {
            throw std::runtime_error(lesson.name + " needs " + extension + ", which " +
                                     gl_string(GL_RENDERER) + " lacks: try an earlier step");
        }
    }
    for (const Limit& limit : lesson.limits) {
        GLint value = 0;
        glGetIntegerv(limit.name, &value);
        if (value < limit.minimum) {
            throw std::runtime_error(lesson.name + " needs " + std::to_string(limit.minimum) + " " +
                                     limit.what + ", " + gl_string(GL_RENDERER) + " has " +
                                     std::to_string(value) + ": try an earlier step");
        }
    }
}

void print_debug_messages()
{
    if (!has_extension("GL_KHR_debug"))
        throw std::runtime_error("--debug needs GL_KHR_debug, which this OpenGL lacks");
    glEnable(GL_DEBUG_OUTPUT);
    glEnable(GL_DEBUG_OUTPUT_SYNCHRONOUS);
    glDebugMessageCallback(on_message, nullptr);
}

void check_memory(const char* what, double bytes)
{
    bool short_of_memory = false;
    while (const GLenum error = glGetError()) short_of_memory |= error == GL_OUT_OF_MEMORY;
    if (!short_of_memory) return;
    char line[160];
    std::snprintf(line, sizeof line,
                  "not enough memory on %s: %s need %.0f MiB (try fewer --particles or --voxels)",
                  gl_string(GL_RENDERER), what, bytes / (1 << 20));
    throw std::runtime_error(line);
}

void check_framebuffer(const char* what)
{
    const GLenum status = glCheckFramebufferStatus(GL_FRAMEBUFFER);
    if (status == GL_FRAMEBUFFER_COMPLETE) return;
    char line[160];
    std::snprintf(line, sizeof line, "%s cannot draw %s: framebuffer status 0x%04X",
                  gl_string(GL_RENDERER), what, status);
    throw std::runtime_error(line);
}

// Of a context that is lost nothing can be asked, and calls do nothing: not even an error is there.
void check_read_back(const char* what)
{
    const GLenum error = glGetError();
    const bool lost = gl_string(GL_VERSION) == nullptr;
    if (!lost && error == GL_NO_ERROR) return;
    char line[160];
    std::snprintf(line, sizeof line, "cannot read back %s: %s 0x%04X (on %s)", what,
                  lost ? "the context is lost, error" : "OpenGL error", error,
                  renderer_of_context.c_str());
    throw std::runtime_error(line);
}

std::string renderer_name()
{
    return renderer_of_context;
}

bool renders_in_software()
{
    const std::string renderer = lower_case(renderer_name());  // "virgl (LLVMPIPE ...)", too
    for (const char* name : {"llvmpipe", "lavapipe", "softpipe", "swrast", "software", "swr",
                             "gdi generic", "basic render"}) {
        if (renderer.find(name) != std::string::npos) return true;
    }
    return false;
}
