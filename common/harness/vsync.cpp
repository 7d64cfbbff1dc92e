#include "common/harness/vsync.hpp"

#include <GL/glew.h>
#ifdef _WIN32
#include <GL/wglew.h>
#else
#include <GL/glxew.h>  // in a file of its own: X11 has a type called Window, too
#endif

bool set_vsync(bool wait)
{
#ifdef _WIN32
    if (!WGLEW_EXT_swap_control) return !wait;  // what cannot be set is off
    return wglSwapIntervalEXT(wait ? 1 : 0);
#else
    if (!GLXEW_EXT_swap_control) return !wait;  // what cannot be set is off
    glXSwapIntervalEXT(glXGetCurrentDisplay(), glXGetCurrentDrawable(), wait ? 1 : 0);
    return true;
#endif
}

const char* vsync_state()
{
#ifdef _WIN32
    if (!WGLEW_EXT_swap_control) return "off (not reported)";
    return wglGetSwapIntervalEXT() != 0 ? "on" : "off";
#else
    // Mesa's own way first: its software renderer crashes when asked in the other.
    if (GLXEW_MESA_swap_control) return glXGetSwapIntervalMESA() != 0 ? "on" : "off";
    if (!GLXEW_EXT_swap_control) return "off (not reported)";
    unsigned interval = 0;
    glXQueryDrawable(glXGetCurrentDisplay(), glXGetCurrentDrawable(), GLX_SWAP_INTERVAL_EXT,
                     &interval);
    return interval != 0 ? "on" : "off";
#endif
}

void release_context()
{
#ifdef _WIN32
    wglMakeCurrent(nullptr, nullptr);
#else
    glXMakeCurrent(glXGetCurrentDisplay(), None, nullptr);
#endif
}
