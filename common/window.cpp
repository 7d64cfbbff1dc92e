#include "common/window.hpp"

#include <GL/glew.h>
#include <GL/freeglut.h>

#include <algorithm>

static Window* the_window = nullptr;  // GLUT's callbacks are plain functions

Window::Window(std::string name, glm::ivec2 size, const Camera& camera, bool debug)
    : camera_(camera), size_(size), next_size_(size)
{
    the_window = this;
    char* arguments[] = {name.data(), nullptr};
    int count = 1;
    glutInit(&count, arguments);
    // No version is asked for: the driver then gives its newest compatibility context, in which the
    // fixed-function drawing of steps 1 and 2 and the shaders of the later ones both work.
    if (debug) glutInitContextFlags(GLUT_DEBUG);
    glutInitDisplayMode(GLUT_DOUBLE | GLUT_RGBA | GLUT_DEPTH);
    glutInitWindowSize(size.x, size.y);
    glutSetOption(GLUT_ACTION_ON_WINDOW_CLOSE, GLUT_ACTION_CONTINUE_EXECUTION);
    glutCreateWindow(name.c_str());

    glutDisplayFunc([] {});  // required; the frames are drawn by begin_frame's caller
    glutReshapeFunc([](int width, int height) {
        the_window->next_size_ = {std::max(width, 1), std::max(height, 1)};
    });
    glutKeyboardFunc([](unsigned char key, int x, int y) { the_window->press_key(key, x, y); });
    glutIgnoreKeyRepeat(1);
    glutMouseFunc(
        [](int button, int state, int x, int y) { the_window->on_button(button, state, x, y); });
    glutMotionFunc([](int x, int y) { the_window->on_motion(x, y); });
    glutPassiveMotionFunc([](int x, int y) { the_window->on_motion(x, y); });
    // freeglut destroys window and context after this. But in X11 a context that is current lives
    // on until it no longer is (GLX 1.4, 3.3.7), so what was computed can still be read back, and
    // objects deleted. Where it would not live on, the window is not closed before the end.
    glutCloseFunc([] { the_window->on_close(); });
}

Window::~Window()
{
    glutExit();  // at once; glutDestroyWindow would only queue it for a main loop that is over
    the_window = nullptr;
}

bool Window::begin_frame()
{
    if (!frame_begins()) return false;
    size_ = next_size_;
    return true;
}

void Window::swap_buffers()
{
    drawn_ = true;
    take_events();
    drawn_ = false;
    if (gone_) return;  // and with it what was drawn
    save_frame();
    draw_panel();
    glutSwapBuffers();
    frame_is_shown();
}

void Window::take_events()
{
    glutMainLoopEvent();
}

void Window::on_close()
{
    closing_ = gone_ = true;
    if (drawn_) save_frame();
}

void Window::on_button(int button, int state, int x, int y)
{
    constexpr int wheel_up = 3, wheel_down = 4;  // X11's buttons, which freeglut passes on
    mouse_ = {x, y};
    dragging_ = false;
    if (press_button(button, state, x, y) || state != GLUT_DOWN) return;
    if (button == wheel_up) camera_.zoom(1);
    if (button == wheel_down) camera_.zoom(-1);
    dragging_ = button == GLUT_LEFT_BUTTON;
}

void Window::on_motion(int x, int y)
{
    move_mouse(x, y);
    const glm::ivec2 mouse(x, y);
    if (dragging_) {
        touring_ = false;
        camera_.orbit(glm::vec2(mouse - mouse_));
    }
    mouse_ = mouse;
}
