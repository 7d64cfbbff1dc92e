#include "common/vsync.hpp"

#include <GL/glew.h>
#ifdef _WIN32
#include <GL/wglew.h>
#else
#include <GL/glxew.h>  // in a file of its own: X11 has a type called Window, too
#endif

bool set_vsync(bool wait)
{
#ifdef _WIN32
    return WGLEW_EXT_swap_control && wglSwapIntervalEXT(wait ? 1 : 0);
#else
    if (!GLXEW_EXT_swap_control) return !wait;  // what cannot be set is off
    glXSwapIntervalEXT(glXGetCurrentDisplay(), glXGetCurrentDrawable(), wait ? 1 : 0);
    return true;
#endif
}
