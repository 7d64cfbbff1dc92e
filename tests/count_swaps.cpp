// Loaded into a program with LD_PRELOAD, counts the frames that it shows and leaves their number in
// the file that SWAPS_FILE names.
#include <dlfcn.h>

#include <cstdio>
#include <cstdlib>

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

}  // namespace

// Stands in the way of GLX's own function. Both arguments pass through unseen: a pointer and an id.
extern "C" void glXSwapBuffers(void* display, unsigned long drawable)
{
    using Function = void (*)(void*, unsigned long);
    static const auto original = reinterpret_cast<Function>(dlsym(RTLD_NEXT, "glXSwapBuffers"));
    ++count.swaps;
    original(display, drawable);
}
