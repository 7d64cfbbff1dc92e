// Loaded into a program with LD_PRELOAD, counts its draws in which nobody feeds attribute 0, which
// some drivers leave out in a compatibility context, and leaves their number, and that of all, in
// the file that DRAWS_FILE names.
#include <GL/glew.h>
#include <dlfcn.h>

#include <cstdio>
#include <cstdlib>

namespace {

struct Count {
    long unfed = 0, all = 0;
    ~Count()  // at the end of the program
    {
        const char* path = std::getenv("DRAWS_FILE");
        std::FILE* file = path ? std::fopen(path, "w") : nullptr;
        if (!file) return;
        std::fprintf(file, "%ld %ld", unfed, all);
        std::fclose(file);
    }
} count;

}  // namespace

// Stands in the way of OpenGL's own function. The older ones, with which steps 1 and 2 draw, have
// an array of their own for positions.
extern "C" void glDrawArrays(GLenum mode, GLint first, GLsizei number)
{
    using Draw = void (*)(GLenum, GLint, GLsizei);
    using Get = void (*)(GLuint, GLenum, GLint*);
    static const auto draw = reinterpret_cast<Draw>(dlsym(RTLD_NEXT, "glDrawArrays"));
    static const auto get = reinterpret_cast<Get>(dlsym(RTLD_NEXT, "glGetVertexAttribiv"));
    GLint enabled = glIsEnabled(GL_VERTEX_ARRAY);
    if (!enabled) get(0, GL_VERTEX_ATTRIB_ARRAY_ENABLED, &enabled);
    count.unfed += enabled == 0;
    ++count.all;
    draw(mode, first, number);
}
