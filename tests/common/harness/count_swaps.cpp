// Loaded into a program with LD_PRELOAD, counts the frames that it shows and leaves their number in
// the file that SWAPS_FILE names. SWAPS_LOAD, "first last ms others", makes those frames take so
// much longer, and all others so much. SWAPS_LOSE takes the program's OpenGL context away after
// the third frame: as if the driver had been reset, or the window had been closed under it.
#include <dlfcn.h>

#include <cstdio>
#include <cstdlib>
#include <thread>

namespace {

struct Count {
    long swaps = 0;
    ~Count()  // at the end of the program
    {
        const char* path = std::getenv("SWAPS_FILE");
        std::FILE* file = path ? std::fopen(path, "w") : nullptr;
        if (!file) return;
        std::fprintf(file, "%ld", swaps);
        std::fclose(file);
    }
} count;

struct Load {
    long first = 0, last = 0, milliseconds = 0, others = 0;
    Load()
    {
        const char* load = std::getenv("SWAPS_LOAD");
        if (load) std::sscanf(load, "%ld %ld %ld %ld", &first, &last, &milliseconds, &others);
    }
} load;

}  // namespace

// Stands in the way of GLX's own function, whose arguments pass through unseen: a pointer and an
// id.
extern "C" void glXSwapBuffers(void* display, unsigned long drawable)
{
    using Function = void (*)(void*, unsigned long);
    static const auto original = reinterpret_cast<Function>(dlsym(RTLD_NEXT, "glXSwapBuffers"));
    ++count.swaps;
    const bool loaded = count.swaps >= load.first && count.swaps <= load.last;
    const long wait = loaded ? load.milliseconds : load.others;
    if (wait > 0) std::this_thread::sleep_for(std::chrono::milliseconds(wait));
    original(display, drawable);
    if (count.swaps == 3 && std::getenv("SWAPS_LOSE")) {
        using Release = int (*)(void*, unsigned long, void*);
        reinterpret_cast<Release>(dlsym(RTLD_NEXT, "glXMakeCurrent"))(display, 0, nullptr);
    }
}
