#include "common/harness/driver.hpp"

#include <GL/glew.h>
#ifdef _WIN32
#include <GL/freeglut.h>
#include <GL/wglew.h>
#include <io.h>
#define isatty _isatty

static std::function<void()> ask_for_the_end;
static WNDPROC freeglut_procedure = nullptr;

static LRESULT CALLBACK window_procedure(HWND window, UINT message, WPARAM first, LPARAM second)
{
    if (message != WM_CLOSE)
        return CallWindowProc(freeglut_procedure, window, message, first, second);
    ask_for_the_end();
    return 0;
}

bool set_vsync(bool wait)
{
    return WGLEW_EXT_swap_control && wglSwapIntervalEXT(wait ? 1 : 0);
}

void set_title(const char* title)
{
    glutSetWindowTitle(title);
}

void watch_display() {}

// freeglut would delete the context while the frame is still being drawn.
void take_close_button(const std::function<void()>& ask)
{
    ask_for_the_end = ask;
    freeglut_procedure =
        reinterpret_cast<WNDPROC>(SetWindowLongPtr(WindowFromDC(wglGetCurrentDC()), GWLP_WNDPROC,
                                                   reinterpret_cast<LONG_PTR>(window_procedure)));
}

#else
#include <GL/glxew.h>  // in a file of its own: X11 has a type called Window, too
#include <X11/Xatom.h>
#include <unistd.h>

#include <cstdio>
#include <cstdlib>
#include <cstring>

bool set_vsync(bool wait)
{
    if (!GLXEW_EXT_swap_control) return false;
    glXSwapIntervalEXT(glXGetCurrentDisplay(), glXGetCurrentDrawable(), wait ? 1 : 0);
    return true;
}

// Not by glutSetWindowTitle: that of freeglut 3.8 ends the program (BadAtom in XDeleteProperty)
// where no window manager runs, as under xvfb-run.
void set_title(const char* title)
{
    Display* const display = glXGetCurrentDisplay();
    if (display == nullptr) return;  // freeglut on Wayland
    const GLXDrawable window = glXGetCurrentDrawable();
    XStoreName(display, window, title);
    XChangeProperty(display, window, XInternAtom(display, "_NET_WM_NAME", False),
                    XInternAtom(display, "UTF8_STRING", False), 8, PropModeReplace,
                    reinterpret_cast<const unsigned char*>(title), int(std::strlen(title)));
}

void watch_display()
{
    XSetIOErrorHandler([](Display*) -> int {
        std::fputs("error: the display has gone, and with it all that was to be written after the "
                   "last frame\n",
                   stderr);
        std::_Exit(1);
    });
}

void take_close_button(const std::function<void()>&) {}

#endif

bool is_watched()
{
    return isatty(2) != 0;
}
