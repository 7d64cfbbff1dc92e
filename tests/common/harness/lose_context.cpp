// Loaded into a program with LD_PRELOAD, takes its OpenGL context away after the third frame: as if
// the graphics driver had been reset, or the window had been closed under it.
#include <dlfcn.h>

// Stands in the way of GLX's own functions. The arguments pass through unseen: a pointer and ids.
extern "C" void glXSwapBuffers(void* display, unsigned long drawable)
{
    using Swap = void (*)(void*, unsigned long);
    using Release = int (*)(void*, unsigned long, void*);
    static const auto swap = reinterpret_cast<Swap>(dlsym(RTLD_NEXT, "glXSwapBuffers"));
    static const auto release = reinterpret_cast<Release>(dlsym(RTLD_NEXT, "glXMakeCurrent"));
    static int frames = 0;
    swap(display, drawable);
    if (++frames == 3) release(display, 0, nullptr);
}
