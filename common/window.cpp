#include "common/window.hpp"

#include <GL/glew.h>
#include <GL/freeglut.h>

#include <algorithm>
#include <cmath>
#include <cstdarg>
#include <cstdio>
#include <cstdlib>
#include <iostream>
#include <stdexcept>

#include "common/output.hpp"
#include "common/vsync.hpp"

namespace {

Window* the_window = nullptr;  // GLUT's callbacks are plain functions

const char* gl_string(GLenum name)
{
    return reinterpret_cast<const char*>(glGetString(name));
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

void GLAPIENTRY on_gl_message(GLenum, GLenum, GLuint, GLenum severity, GLsizei,
                              const GLchar* message, const void*)
{
    if (severity == GL_DEBUG_SEVERITY_NOTIFICATION) return;
    std::cerr << "OpenGL" << (severity == GL_DEBUG_SEVERITY_HIGH ? " (high severity): " : ": ")
              << message << "\n";
}

}  // namespace

Window::Window(const Options& options) : options_(options), size_(options.size)
{
    the_window = this;
    glutInitErrorFunc(on_glut_error);
    glutInitWarningFunc(on_glut_warning);
    std::string name = options.step.name;
    char* arguments[] = {name.data(), nullptr};
    int count = 1;
    glutInit(&count, arguments);
    // No version is asked for: the driver then gives its newest compatibility context, in which the
    // fixed-function drawing of steps 1 and 2 and the shaders of the later ones both work.
    if (options.debug) glutInitContextFlags(GLUT_DEBUG);
    glutInitDisplayMode(GLUT_DOUBLE | GLUT_RGBA | GLUT_DEPTH);
    glutInitWindowSize(size_.x, size_.y);
    glutSetOption(GLUT_ACTION_ON_WINDOW_CLOSE, GLUT_ACTION_CONTINUE_EXECUTION);
    window_ = glutCreateWindow(name.c_str());

    glewExperimental = GL_TRUE;
    const GLenum status = glewInit();
    // Without a GLX display (under Wayland) GLEW has still loaded OpenGL's own functions.
    if (status != GLEW_OK && status != GLEW_ERROR_NO_GLX_DISPLAY) {
        throw std::runtime_error(std::string("cannot load OpenGL's functions: ") +
                                 reinterpret_cast<const char*>(glewGetErrorString(status)));
    }
    check_gl();
    if (options.debug) {
        if (!GLEW_KHR_debug)
            throw std::runtime_error("--debug needs GL_KHR_debug, which this OpenGL lacks");
        glEnable(GL_DEBUG_OUTPUT);
        glEnable(GL_DEBUG_OUTPUT_SYNCHRONOUS);
        glDebugMessageCallback(on_gl_message, nullptr);
    }
    if (!set_vsync(options.vsync)) {
        throw std::runtime_error("--vsync: this driver cannot wait for the display");
    }

    glutDisplayFunc([] {});  // required; the frames are drawn by begin_frame's caller
    glutReshapeFunc(on_reshape);
    glutKeyboardFunc(on_key);
    glutMouseFunc(on_button);
    glutMotionFunc(on_drag);
    glutCloseFunc([] {
        the_window->closing_ = true;
        the_window->window_ = 0;
    });
    announce();
    last_frame_ = last_title_ = Clock::now();
}

Window::~Window()
{
    glutExit();  // at once; glutDestroyWindow would only queue it for a main loop that no longer
                 // runs
    the_window = nullptr;
}

void Window::check_gl() const
{
    const std::string version = gl_string(GL_VERSION);
    const double have =
        std::strtod(version.c_str(), nullptr);  // "4.5 (Compatibility Profile) Mesa ..."
    if (have < options_.step.least_gl - 0.01) {
        char line[128];
        std::snprintf(
            line, sizeof line, "%s needs OpenGL %.1f, this is %.1f (%s): try an earlier step",
            options_.step.name.c_str(), options_.step.least_gl, have, gl_string(GL_RENDERER));
        throw std::runtime_error(line);
    }
    for (const char* extension : options_.step.extensions) {
        if (!glewIsSupported(extension)) {
            throw std::runtime_error(options_.step.name + " needs " + extension + ", which " +
                                     gl_string(GL_RENDERER) + " lacks");
        }
    }
}

void Window::announce() const
{
    const std::string renderer = gl_string(GL_RENDERER);
    std::cout << options_.step.name << " " << options_.variant << ": " << renderer << ", OpenGL "
              << gl_string(GL_VERSION) << ", " << options_.weather.particles << " flakes, "
              << size_.x << "x" << size_.y << ", vsync " << (options_.vsync ? "on" : "off")
              << std::endl;
    for (const char* software : {"llvmpipe", "softpipe", "swrast", "SWR"}) {
        if (renderer.find(software) == std::string::npos) continue;
        std::cout
            << "warning: OpenGL runs in software here: times say nothing about a graphics card"
            << std::endl;
    }
}

bool Window::begin_frame()
{
    if (drawn_ > 0 || steps_ > 0) finish_frame();
    glutMainLoopEvent();
    const bool enough = options_.frames && drawn_ >= *options_.frames + options_.warmup;
    if (closing_ || enough) return false;

    steps_ = options_.reproducible() ? 1 : steps_since_last_frame();
    glViewport(0, 0, size_.x, size_.y);
    glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
    ++drawn_;
    return true;
}

void Window::finish_frame()
{
    const bool last = options_.frames && drawn_ == *options_.frames + options_.warmup;
    if (last && !options_.screenshot.empty()) save_screenshot(options_.screenshot, size_);
    glutSwapBuffers();
    show_frame_time();
}

int Window::steps_since_last_frame()
{
    constexpr int most = 8;
    const double time_step = options_.weather.time_step;
    const Clock::time_point now = Clock::now();
    owed_ += std::chrono::duration<double>(now - last_frame_).count();
    last_frame_ = now;
    owed_ = std::min(owed_, most * time_step);
    const int steps = int(owed_ / time_step);
    owed_ -= steps * time_step;
    return steps;
}

void Window::show_frame_time()
{
    const Clock::time_point now = Clock::now();
    const double seconds = std::chrono::duration<double>(now - last_title_).count();
    if (seconds < 0.5) return;
    const unsigned frames = drawn_ - drawn_at_last_title_;
    char title[128];
    std::snprintf(title, sizeof title, "%s %s   %.2f ms a frame, %.0f fps",
                  options_.step.name.c_str(), options_.variant.c_str(), 1000 * seconds / frames,
                  frames / seconds);
    glutSetWindowTitle(title);
    last_title_ = now;
    drawn_at_last_title_ = drawn_;
}

void Window::on_key(unsigned char key, int, int)
{
    constexpr unsigned char escape = 27;
    if (key == escape) the_window->closing_ = true;
    if (key == 'c' || key == 'C') the_window->camera_ = Camera{};
    if (key == 's' || key == 'S')
        save_screenshot(the_window->options_.step.name + ".png", the_window->size_);
}

void Window::on_button(int button, int state, int x, int y)
{
    constexpr int wheel_up = 3, wheel_down = 4;  // X11's numbers, which freeglut passes on
    if (state != GLUT_DOWN) return;
    the_window->mouse_ = {x, y};
    if (button == wheel_up) the_window->camera_.zoom(1);
    if (button == wheel_down) the_window->camera_.zoom(-1);
}

void Window::on_drag(int x, int y)
{
    const glm::ivec2 mouse(x, y);
    the_window->camera_.orbit(glm::vec2(mouse - the_window->mouse_));
    the_window->mouse_ = mouse;
}

void Window::on_reshape(int width, int height)
{
    the_window->size_ = {std::max(width, 1), std::max(height, 1)};
}

int report_failure(const std::exception& failure)
{
    std::cerr << "error: " << failure.what() << std::endl;
    return 1;
}
