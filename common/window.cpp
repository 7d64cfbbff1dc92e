#include "common/window.hpp"

#include <GL/glew.h>
#include <GL/freeglut.h>

#include <algorithm>
#include <backends/imgui_impl_glut.h>
#include <cctype>
#include <cstdarg>
#include <cstdio>
#include <cstdlib>
#include <iostream>
#include <stdexcept>
#include <utility>

#include "common/output.hpp"
#include "common/tour.hpp"
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

Window::Window(Options options)
    : options_(std::move(options)), camera_(options_.camera), show_panel_(!options_.reproducible()),
      size_(options_.size), touring_(options_.tour)
{
    the_window = this;
    glutInitErrorFunc(on_glut_error);
    glutInitWarningFunc(on_glut_warning);
    std::string name = options_.step.name;
    char* arguments[] = {name.data(), nullptr};
    int count = 1;
    glutInit(&count, arguments);
    // No version is asked for: the driver then gives its newest compatibility context, in which the
    // fixed-function drawing of steps 1 and 2 and the shaders of the later ones both work.
    if (options_.debug) glutInitContextFlags(GLUT_DEBUG);
    glutInitDisplayMode(GLUT_DOUBLE | GLUT_RGBA | GLUT_DEPTH);
    glutInitWindowSize(size_.x, size_.y);
    glutSetOption(GLUT_ACTION_ON_WINDOW_CLOSE, GLUT_ACTION_CONTINUE_EXECUTION);
    glutCreateWindow(name.c_str());

    glewExperimental = GL_TRUE;
    const GLenum status = glewInit();
    // Without a GLX display (under Wayland) GLEW has still loaded OpenGL's own functions.
    if (status != GLEW_OK && status != GLEW_ERROR_NO_GLX_DISPLAY) {
        throw std::runtime_error(std::string("cannot load OpenGL's functions: ") +
                                 reinterpret_cast<const char*>(glewGetErrorString(status)));
    }
    check_gl();
    if (options_.debug) {
        if (!GLEW_KHR_debug)
            throw std::runtime_error("--debug needs GL_KHR_debug, which this OpenGL lacks");
        glEnable(GL_DEBUG_OUTPUT);
        glEnable(GL_DEBUG_OUTPUT_SYNCHRONOUS);
        glDebugMessageCallback(on_gl_message, nullptr);
    }
    if (!set_vsync(options_.vsync)) {
        throw std::runtime_error("--vsync: this driver cannot wait for the display");
    }

    glutDisplayFunc([] {});  // required; the frames are drawn by begin_frame's caller
    glutReshapeFunc(on_reshape);
    glutKeyboardFunc(on_key);
    glutMouseFunc(on_button);
    glutMotionFunc(on_motion);
    glutPassiveMotionFunc(on_motion);
    // freeglut destroys window and context after this. But a context that is current lives on until
    // it no longer is (GLX 1.4, 3.3.7), so what was computed can still be read back, and objects
    // deleted.
    glutCloseFunc([] { the_window->closing_ = the_window->window_gone_ = true; });
    announce();
    last_frame_ = last_swap_ = last_title_ = Clock::now();
}

Window::~Window()
{
    panel_.reset();
    release_context();
    glutExit();  // at once; glutDestroyWindow would only queue it for a main loop that is over
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

void Window::announce()
{
    const std::string renderer = gl_string(GL_RENDERER);
    for (const char* name : {"llvmpipe", "softpipe", "swrast", "SWR"}) {
        software_ |= renderer.find(name) != std::string::npos;
    }
    std::cout << options_.step.name << " " << options_.variant << ": " << renderer << ", OpenGL "
              << gl_string(GL_VERSION) << ", " << options_.weather.particles << " flakes, "
              << size_.x << "x" << size_.y << ", vsync " << vsync_state() << std::endl;
    if (software_) {
        std::cout
            << "warning: OpenGL runs in software here: times say nothing about a graphics card"
            << std::endl;
    }
}

bool Window::begin_frame()
{
    glutMainLoopEvent();
    const bool enough = options_.frames && drawn_ >= *options_.frames + options_.warmup;
    const bool last = closing_ || enough;
    if (frame_open_) finish_frame(last);
    if (last || controls_.restart) {
        report();
        return false;
    }
    weather_changed_ = std::exchange(controls_.weather_changed, false);
    const Clock::time_point now = Clock::now();
    frame_seconds_ = std::chrono::duration<double>(now - last_frame_).count();
    last_frame_ = now;
    steps_ = steps_of_this_frame();
    if (touring_) fly();
    glViewport(0, 0, size_.x, size_.y);
    glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
    // Software renderers answer some queries with 0: there the last frames of a benchmark's warm-up
    // are a pass of its own, in which the stages wait for each other and can be told apart.
    const unsigned pass = std::min(60u, options_.warmup / 2);
    const bool warm = drawn_ >= options_.warmup;
    const bool synchronised =
        options_.benchmark && software_ && !warm && drawn_ + pass >= options_.warmup;
    if (synchronised || (measuring() ? warm : show_panel_)) timer_.begin_frame(synchronised);
    frame_open_ = true;
    ++drawn_;
    return true;
}

void Window::finish_frame(bool last)
{
    frame_open_ = false;
    if (window_gone_) {  // and with it what was drawn
        timer_.drop_frame();
        return;
    }
    if (last && !options_.screenshot.empty()) save_screenshot(options_.screenshot, size_);
    if (!options_.record.empty() && drawn_ > options_.warmup) {
        char name[32];
        std::snprintf(name, sizeof name, "%06u.png", drawn_ - options_.warmup);
        save_screenshot(options_.record / name, size_);
    }
    if (std::exchange(save_screenshot_, false)) save_screenshot(options_.step.name + ".png", size_);
    if (show_panel_) {
        const auto panel_stage = stage("panel");
        if (panel_ == nullptr) panel_ = std::make_unique<Panel>();
        panel_->draw(size_, options_, controls_, timer_.frames(), gl_string(GL_RENDERER));
    }
    glutSwapBuffers();
    const Clock::time_point now = Clock::now();
    timer_.end_frame(std::chrono::duration<double, std::milli>(now - last_swap_).count());
    if (!measuring()) timer_.keep(300);
    last_swap_ = now;
    show_frame_time();
}

// What was measured, also when the window was closed before the end.
void Window::report()
{
    if (!measuring()) return;
    timer_.finish();
    if (options_.benchmark) {
        print_summary(timer_.frames());
        const unsigned asked = *options_.frames + options_.warmup;
        if (drawn_ < asked) {
            std::cout << "benchmark: cut short after " << drawn_ << " of " << asked
                      << " frames, warm-up included" << std::endl;
        }
    }
    if (!options_.csv.empty()) {
        write_csv(options_.csv, options_, size_, gl_string(GL_RENDERER), timer_.frames());
    }
}

bool Window::again()
{
    if (closing_ || !controls_.restart) return false;
    controls_.restart = false;
    drawn_ = drawn_at_last_title_ = 0;
    timer_.clear();
    announce();
    last_frame_ = last_swap_ = last_title_ = Clock::now();
    return true;
}

int Window::steps_of_this_frame()
{
    const double time_step = options_.weather.time_step, timelapse = options_.timelapse;
    constexpr int most = 8;
    owed_ = std::min(owed_ + timelapse * frame_seconds_, most * timelapse * time_step);
    if (controls_.paused) {
        owed_ = 0;
        return std::exchange(controls_.single_step, false) ? 1 : 0;
    }
    if (options_.reproducible()) return int(options_.timelapse);
    const int steps = int(owed_ / time_step);
    owed_ -= steps * time_step;
    return steps;
}

// In a reproducible run a frame is a 60th of a second, so that a recording can be repeated.
void Window::fly()
{
    const View view = tour(float(tour_time_));
    camera_.look(view.eye, view.target);
    if (drawn_ >= options_.warmup)
        tour_time_ += options_.reproducible() ? 1 / 60.0 : frame_seconds_;
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

void Window::on_key(unsigned char key, int x, int y)
{
    constexpr unsigned char escape = 27;
    Window& window = *the_window;
    if (window.panel_ && window.show_panel_) {
        ImGui_ImplGLUT_KeyboardFunc(key, x, y);
        if (window.panel_->wants_keys()) return;  // a number is being typed into a slider
    }
    switch (std::tolower(key)) {
    case escape:
        window.closing_ = true;
        break;
    case 'c':
        window.camera_ = window.options_.camera;
        window.touring_ = false;
        break;
    case 'h':
        window.show_panel_ = !window.show_panel_;
        break;
    case ' ':
        window.controls_.paused = !window.controls_.paused;
        break;
    case 'r':
        window.controls_.restart = true;
        break;
    case 's':
        window.save_screenshot_ = true;
        break;
    case 't':
        window.touring_ = !window.touring_;
        break;
    default:
        for (Setting& setting : window.options_.step.settings) {
            if (std::toupper(key) == setting.key) setting.value = setting.value != 0 ? 0.0f : 1.0f;
        }
        break;
    }
}

void Window::on_button(int button, int state, int x, int y)
{
    constexpr int wheel_up = 3, wheel_down = 4;  // X11's numbers, which freeglut passes on
    Window& window = *the_window;
    window.mouse_ = {x, y};
    window.dragging_ = false;
    if (window.panel_ && window.show_panel_) {
        ImGui_ImplGLUT_MouseFunc(button, state, x, y);
        if (window.panel_->wants_mouse()) return;
    }
    if (state != GLUT_DOWN) return;
    if (button == wheel_up) window.camera_.zoom(1);
    if (button == wheel_down) window.camera_.zoom(-1);
    window.dragging_ = button == GLUT_LEFT_BUTTON;
}

void Window::on_motion(int x, int y)
{
    Window& window = *the_window;
    if (window.panel_) ImGui_ImplGLUT_MotionFunc(x, y);
    const glm::ivec2 mouse(x, y);
    if (window.dragging_) {
        window.touring_ = false;
        window.camera_.orbit(glm::vec2(mouse - window.mouse_));
    }
    window.mouse_ = mouse;
}

void Window::on_reshape(int width, int height)
{
    the_window->size_ = {std::max(width, 1), std::max(height, 1)};
}

int run_program(int argc, char** argv, const Step& step,
                const std::function<void(Window&)>& program)
try {
    Window window(parse_options(argc, argv, step));
    program(window);
    return 0;
} catch (const std::exception& failure) {
    std::cerr << "error: " << failure.what() << std::endl;
    return 1;
}
