#include "common/window.hpp"

#include <GL/glew.h>
#include <GL/freeglut.h>

#include <algorithm>
#include <cctype>
#include <stdexcept>
#include <utility>

#include "common/harness/driver.hpp"
#include "common/harness/harness.hpp"
#include "common/harness/window_system.hpp"

static Window* the_window = nullptr;  // GLUT's callbacks are plain functions

Window::Window(CommandLine command)
    : harness_(std::make_unique<Harness>(std::move(command))), options_(harness_->command),
      camera_(harness_->command.camera), size_(harness_->command.size), next_size_(size_)
{
    the_window = this;
    report_glut_errors();
    std::string name = harness_->command.lesson.name;
    char* arguments[] = {name.data(), nullptr};
    int count = 1;
    glutInit(&count, arguments);
    // No version is asked for: the driver then gives its newest compatibility context, in which the
    // fixed-function drawing of steps 1 and 2 and the shaders of the later ones both work.
    if (harness_->command.debug) glutInitContextFlags(GLUT_DEBUG);
    glutInitDisplayMode(GLUT_DOUBLE | GLUT_RGBA | GLUT_DEPTH);
    glutInitWindowSize(size_.x, size_.y);
    glutSetOption(GLUT_ACTION_ON_WINDOW_CLOSE, GLUT_ACTION_CONTINUE_EXECUTION);
    glutCreateWindow(name.c_str());

    load_opengl();
    check_opengl(harness_->command.lesson);
    if (harness_->command.debug) print_debug_messages();
    if (!set_vsync(harness_->command.vsync)) {
        throw std::runtime_error("--vsync: this driver cannot wait for the display");
    }

    glutDisplayFunc([] {});  // required; the frames are drawn by begin_frame's caller
    glutReshapeFunc(on_reshape);
    glutKeyboardFunc(on_key);
    glutIgnoreKeyRepeat(1);
    harness_->let_panel_listen();
    glutMouseFunc(on_button);
    glutMotionFunc(on_motion);
    glutPassiveMotionFunc(on_motion);
    // freeglut destroys window and context after this. But in X11 a context that is current lives
    // on until it no longer is (GLX 1.4, 3.3.7), so what was computed can still be read back, and
    // objects deleted. Where it would not live on, the window is not closed before the end.
    glutCloseFunc([] { the_window->on_close(); });
    take_close_button([] { the_window->closing_ = true; });
    catch_interrupts();
    harness_->begin_run();
    glutMainLoopEvent();  // it is mapped, and may at once be of another size
}

Window::~Window()
{
    harness_.reset();
    release_context();
    glutExit();  // at once; glutDestroyWindow would only queue it for a main loop that is over
    the_window = nullptr;
}

bool Window::begin_frame()
{
    if (closing_ || harness_->failed() || harness_->enough() || harness_->controls.restart) {
        harness_->report(size_);
        return false;
    }
    size_ = next_size_;
    harness_->begin_frame(camera_);
    return true;
}

bool Window::restarted()
{
    if (closing_ || !harness_->controls.restart) return false;
    harness_->begin_run();
    return true;
}

void Window::swap_buffers()
{
    drawn_ = true;
    take_events();
    drawn_ = false;
    if (gone_) return harness_->drop_frame();  // and with it what was drawn
    harness_->record(size_, closing_ || harness_->enough());
    harness_->draw_panel(size_);
    glutSwapBuffers();
    harness_->frame_shown();
}

// The last moment at which what was drawn can be saved.
void Window::on_close()
{
    closing_ = gone_ = true;
    if (drawn_) harness_->record(size_, true);
}

void Window::take_events()
{
    glutMainLoopEvent();
    closing_ |= interrupted();
}

bool Window::next_tick()
{
    if (harness_->events_are_due()) take_events();
    return !closing_ && harness_->pacing.next_tick();
}

void Window::on_key(unsigned char key, int x, int y)
{
    constexpr unsigned char escape = 27;
    Window& window = *the_window;
    if (window.harness_->panel_takes_key(key, x, y)) return;
    if (key == escape) {
        window.closing_ = true;
    } else if (std::tolower(key) == 'c') {
        window.camera_ = window.harness_->command.camera;
        window.harness_->controls.touring = false;
    } else {
        window.harness_->on_key(key);
    }
}

void Window::on_button(int button, int state, int x, int y)
{
    Window& window = *the_window;
    window.mouse_ = {x, y};
    window.dragging_ = false;
    if (window.harness_->panel_takes_button(button, state, x, y)) return;
    if (state != GLUT_DOWN) return;
    if (button == Harness::wheel_up) window.camera_.zoom(1);
    if (button == Harness::wheel_down) window.camera_.zoom(-1);
    window.dragging_ = button == GLUT_LEFT_BUTTON;
}

void Window::on_motion(int x, int y)
{
    Window& window = *the_window;
    window.harness_->panel_sees_mouse(x, y);
    const glm::ivec2 mouse(x, y);
    if (window.dragging_) {
        window.harness_->controls.touring = false;
        window.camera_.orbit(glm::vec2(mouse - window.mouse_));
    }
    window.mouse_ = mouse;
}

void Window::on_reshape(int width, int height)
{
    the_window->next_size_ = {std::max(width, 1), std::max(height, 1)};
}
