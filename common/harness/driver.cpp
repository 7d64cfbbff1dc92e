#include "common/harness/driver.hpp"

#include <GL/glew.h>
#include <GL/freeglut.h>

#include <algorithm>
#include <cctype>
#include <cstdarg>
#include <cstdio>
#include <cstdlib>
#include <iostream>
#include <stdexcept>

#include "common/lesson.hpp"

namespace {

std::string renderer;

std::string gl_string(GLenum name)
{
    return reinterpret_cast<const char*>(glGetString(name));
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
    std::fputs(" (is there a display, in DISPLAY, and has it OpenGL? `glxinfo -B` tells, and "
               "`xvfb-run` provides one without a screen)\n",
               stderr);
    std::_Exit(1);
}

// Steps 1 to 3 draw with fixed functions, and so does the panel.
bool is_core_profile()
{
    GLint profile = 0, flags = 0;
    if (GLEW_VERSION_3_2) glGetIntegerv(GL_CONTEXT_PROFILE_MASK, &profile);
    if (GLEW_VERSION_3_0) glGetIntegerv(GL_CONTEXT_FLAGS, &flags);
    return (profile & GL_CONTEXT_CORE_PROFILE_BIT) != 0 ||
           (flags & GL_CONTEXT_FLAG_FORWARD_COMPATIBLE_BIT) != 0;
}

void check_opengl(const Lesson& lesson)
{
    const auto need = [&lesson](const std::string& what, const std::string& there_is) {
        throw std::runtime_error(lesson.name + " needs " + what + ", " + renderer + " has " +
                                 there_is + ": try an earlier step");
    };
    const std::string version = gl_string(GL_VERSION);  // "4.5 (Compatibility Profile) Mesa ..."
    if (std::strtod(version.c_str(), nullptr) < lesson.minimum_gl - 0.01) {
        char number[8];
        std::snprintf(number, sizeof number, "%.1f", lesson.minimum_gl);
        need(std::string("OpenGL ") + number, version);
    }
    if (is_core_profile()) {
        throw std::runtime_error(lesson.name +
                                 " needs a compatibility profile of OpenGL, this is " + version +
                                 " without (is MESA_GL_VERSION_OVERRIDE set?)");
    }
    for (const char* extension : lesson.extensions) {
        if (!has_extension(extension)) need(extension, "none");
    }
    for (const Limit& limit : lesson.limits) {
        GLint value = 0;
        glGetIntegerv(limit.name, &value);
        if (value < limit.minimum)
            need(std::to_string(limit.minimum) + " " + limit.what, std::to_string(value));
    }
}

}  // namespace

void report_glut_errors()
{
    glutInitErrorFunc(on_glut_error);
    glutInitWarningFunc([](const char*, va_list) {});
}

void load_opengl(const Lesson& lesson, bool debug)
{
    const GLenum status = glewInit();
    // Without a GLX display (under Wayland) GLEW has still loaded OpenGL's own functions.
    if (status != GLEW_OK && status != GLEW_ERROR_NO_GLX_DISPLAY) {
        throw std::runtime_error(std::string("cannot load OpenGL's functions: ") +
                                 reinterpret_cast<const char*>(glewGetErrorString(status)));
    }
    renderer = gl_string(GL_RENDERER);
    check_opengl(lesson);
    if (!debug) return;
    if (!has_extension("GL_KHR_debug"))
        throw std::runtime_error("--debug needs GL_KHR_debug, which this OpenGL lacks");
    glEnable(GL_DEBUG_OUTPUT);
    glEnable(GL_DEBUG_OUTPUT_SYNCHRONOUS);
    glDebugMessageCallback(on_message, nullptr);
}

bool has_extension(const char* name)
{
    return glewIsSupported(name);
}

const std::string& renderer_name()
{
    return renderer;
}

bool renders_in_software()
{
    std::string name = renderer;  // "virgl (LLVMPIPE ...)", too
    std::transform(name.begin(), name.end(), name.begin(),
                   [](unsigned char c) { return char(std::tolower(c)); });
    for (const char* software : {"llvmpipe", "lavapipe", "softpipe", "swrast", "swr", "software",
                                 "gdi generic", "basic render"}) {
        if (name.find(software) != std::string::npos) return true;
    }
    return false;
}
