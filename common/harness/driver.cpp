#include "common/harness/driver.hpp"

#include <GL/glew.h>
#include <GL/freeglut.h>

#include <cstdarg>
#include <cstdio>
#include <cstdlib>
#include <iostream>
#include <regex>
#include <stdexcept>

#include "common/harness/options.hpp"

static std::string renderer;

static std::string gl_string(GLenum name)
{
    return reinterpret_cast<const char*>(glGetString(name));
}

// Advice, such as on what makes it slow, goes to stdout: stderr is for what is wrong.
static void GLAPIENTRY on_message(GLenum, GLenum type, GLuint, GLenum severity, GLsizei,
                                  const GLchar* message, const void*)
{
    if (severity == GL_DEBUG_SEVERITY_NOTIFICATION) return;
    (type == GL_DEBUG_TYPE_PERFORMANCE ? std::cout : std::cerr)
        << "OpenGL: " << message << std::endl;
}

// freeglut cannot go on after an error, and must not return from this.
static void on_glut_error(const char* format, va_list arguments)
{
    std::fputs("error: ", stderr);
    std::vfprintf(stderr, format, arguments);
    std::fputs(" (is there a display, in DISPLAY, and has it OpenGL? `glxinfo -B` tells, and "
               "`xvfb-run` provides one without a screen)\n",
               stderr);
    std::_Exit(1);
}

// Steps 1 to 3 draw with fixed functions, and so does the panel.
static bool is_core_profile()
{
    GLint profile = 0, flags = 0;
    if (GLEW_VERSION_3_2) glGetIntegerv(GL_CONTEXT_PROFILE_MASK, &profile);
    if (GLEW_VERSION_3_0) glGetIntegerv(GL_CONTEXT_FLAGS, &flags);
    return (profile & GL_CONTEXT_CORE_PROFILE_BIT) != 0 ||
           (flags & GL_CONTEXT_FLAG_FORWARD_COMPATIBLE_BIT) != 0;
}

static void check_opengl(const Lesson& lesson)
{
    const auto need = [&lesson](const std::string& what, const std::string& there_is) {
        throw std::runtime_error(lesson.name + " needs " + what + ", " + renderer + " has " +
                                 there_is + ": try an earlier step");
    };
    const std::string version = gl_string(GL_VERSION);  // "4.5 (Compatibility Profile) Mesa ..."
    if (std::strtod(version.c_str(), nullptr) < lesson.minimum_gl - 0.01)
        need("OpenGL " + std::to_string(lesson.minimum_gl).substr(0, 3), version);
    if (is_core_profile()) {
        throw std::runtime_error(lesson.name +
                                 " needs a compatibility profile of OpenGL, this is " + version +
                                 " without (is MESA_GL_VERSION_OVERRIDE set?)");
    }
    for (const char* extension : lesson.extensions) {
        if (!glewIsSupported(extension)) need(extension, "none");
    }
    for (const Limit& limit : lesson.limits) {
        GLint value = 0;
        glGetIntegerv(limit.name, &value);
        if (value < limit.minimum)
            need(std::to_string(limit.minimum) + " " + limit.what, std::to_string(value));
    }
}

void open_window(const CommandLine& command)
{
    glutInitErrorFunc(on_glut_error);
    glutInitWarningFunc([](const char*, va_list) {});
    std::string name = command.lesson.name;
    char* arguments[] = {name.data(), nullptr};
    int count = 1;
    glutInit(&count, arguments);
    // No version is asked for: the driver then gives its newest compatibility context, in which the
    // fixed-function drawing of steps 1 and 2 and the shaders of the later ones both work.
    if (command.debug) glutInitContextFlags(GLUT_DEBUG);
    glutInitDisplayMode(GLUT_DOUBLE | GLUT_RGBA | GLUT_DEPTH);
    glutInitWindowSize(command.size.x, command.size.y);
    glutSetOption(GLUT_ACTION_ON_WINDOW_CLOSE, GLUT_ACTION_CONTINUE_EXECUTION);
    glutCreateWindow(name.c_str());
    if (command.fullscreen) glutFullScreen();
    watch_display();

    const GLenum status = glewInit();
    // Without a GLX display (under Wayland) GLEW has still loaded OpenGL's own functions.
    if (status != GLEW_OK && status != GLEW_ERROR_NO_GLX_DISPLAY)
        throw std::runtime_error("cannot load OpenGL's functions");
    renderer = gl_string(GL_RENDERER);
    check_opengl(command.lesson);
    if (!command.debug) return;
    if (!GLEW_KHR_debug) throw std::runtime_error("--debug needs GL_KHR_debug, which is not there");
    glEnable(GL_DEBUG_OUTPUT);
    glEnable(GL_DEBUG_OUTPUT_SYNCHRONOUS);
    glDebugMessageCallback(on_message, nullptr);
}

const std::string& renderer_name()
{
    return renderer;
}

bool renders_in_software()
{
    static const std::regex software(
        "llvmpipe|lavapipe|softpipe|swrast|swr|software|gdi generic|basic render",
        std::regex::icase);  // "virgl (LLVMPIPE ...)", too
    return std::regex_search(renderer, software);
}
