#include "common/harness/window_system.hpp"

#include <GL/glew.h>
#ifdef _WIN32
#include <GL/freeglut.h>
#include <GL/wglew.h>
#else
#include <GL/glxew.h>  // in a file of its own: X11 has a type called Window, too
#include <X11/Xatom.h>

#include <cstring>
#endif

#ifdef _WIN32

namespace {

void (*ask_for_the_end)() = nullptr;
WNDPROC freeglut_procedure = nullptr;

LRESULT CALLBACK window_procedure(HWND window, UINT message, WPARAM first, LPARAM second)
{
    if (message != WM_CLOSE)
        return CallWindowProc(freeglut_procedure, window, message, first, second);
    ask_for_the_end();
    return 0;
}

}  // namespace

bool set_vsync(bool wait)
{
    if (!WGLEW_EXT_swap_control) return !wait;  // what cannot be set is off
    return wglSwapIntervalEXT(wait ? 1 : 0) || !wait;
}

const char* vsync_state()
{
    if (!WGLEW_EXT_swap_control) return "off (not reported)";
    return wglGetSwapIntervalEXT() != 0 ? "on" : "off";
}

void set_title(const char* title)
{
    glutSetWindowTitle(title);
}

// freeglut would delete the context while the frame is still being drawn.
void take_close_button(void (*ask)())
{
    ask_for_the_end = ask;
    freeglut_procedure =
        reinterpret_cast<WNDPROC>(SetWindowLongPtr(WindowFromDC(wglGetCurrentDC()), GWLP_WNDPROC,
                                                   reinterpret_cast<LONG_PTR>(window_procedure)));
}

void release_context()
{
    wglMakeCurrent(nullptr, nullptr);
}

#else  // X11

bool set_vsync(bool wait)
{
    if (!GLXEW_EXT_swap_control) return !wait;  // what cannot be set is off
    glXSwapIntervalEXT(glXGetCurrentDisplay(), glXGetCurrentDrawable(), wait ? 1 : 0);
    return true;
}

const char* vsync_state()
{
    // Mesa's own way first: its software renderer crashes when asked in the other.
    if (GLXEW_MESA_swap_control) return glXGetSwapIntervalMESA() != 0 ? "on" : "off";
    if (!GLXEW_EXT_swap_control) return "off (not reported)";
    unsigned interval = 0;
    glXQueryDrawable(glXGetCurrentDisplay(), glXGetCurrentDrawable(), GLX_SWAP_INTERVAL_EXT,
                     &interval);
    return interval != 0 ? "on" : "off";
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

void take_close_button(void (*)()) {}

void release_context()
{
    glXMakeCurrent(glXGetCurrentDisplay(), None, nullptr);
}

#endif
