#include "common/harness/driver.hpp"

#include <GL/glew.h>
#include <GL/freeglut.h>

#include <cstdarg>
#include <cstdio>
#include <cstdlib>
#include <iostream>
#include <stdexcept>

namespace {

const char* gl_string(GLenum name)
{
    return reinterpret_cast<const char*>(glGetString(name));
}

void GLAPIENTRY on_message(GLenum, GLenum, GLuint, GLenum severity, GLsizei, const GLchar* message,
                           const void*)
{
    if (severity == GL_DEBUG_SEVERITY_NOTIFICATION) return;
    std::cerr << "OpenGL" << (severity == GL_DEBUG_SEVERITY_HIGH ? " (high severity): " : ": ")
              << message << "\n";
}

// freeglut cannot go on after an error, and must not return from this.
void on_glut_error(const char* format, va_list arguments)
{
    std::fputs("error: ", stderr);
    std::vfprintf(stderr, format, arguments);
    std::fputs(
        " (is DISPLAY set to a running X server? `xvfb-run` provides one without a screen)\n",
        stderr);
    std::_Exit(1);
}

void on_glut_warning(const char*, va_list) {}

}  // namespace

void report_glut_errors()
{
    glutInitErrorFunc(on_glut_error);
    glutInitWarningFunc(on_glut_warning);
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
        if (!glewIsSupported(extension)) {
            throw std::runtime_error(lesson.name + " needs " + extension + ", which " +
                                     gl_string(GL_RENDERER) + " lacks");
        }
    }
}

void print_debug_messages()
{
    if (!GLEW_KHR_debug)
        throw std::runtime_error("--debug needs GL_KHR_debug, which this OpenGL lacks");
    glEnable(GL_DEBUG_OUTPUT);
    glEnable(GL_DEBUG_OUTPUT_SYNCHRONOUS);
    glDebugMessageCallback(on_message, nullptr);
}

std::string renderer_name()
{
    return gl_string(GL_RENDERER);
}

bool renders_in_software()
{
    const std::string renderer = renderer_name();
    for (const char* name : {"llvmpipe", "softpipe", "swrast", "SWR"}) {
        if (renderer.find(name) != std::string::npos) return true;
    }
    return false;
}
