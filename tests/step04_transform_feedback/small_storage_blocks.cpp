// Loaded into a program with LD_PRELOAD, says that a shader may see 64 KiB of a storage buffer at
// once.
#include <GL/glew.h>
#include <dlfcn.h>

#include <cstring>

namespace {

using GetProcAddress = void (*(*)(const GLubyte*))();
const auto next = reinterpret_cast<GetProcAddress>(dlsym(RTLD_NEXT, "glXGetProcAddressARB"));

void get_integer(GLenum name, GLint64* value)
{
    if (name == GL_MAX_SHADER_STORAGE_BLOCK_SIZE) {
        *value = 65536;
        return;
    }
    using Get = void (*)(GLenum, GLint64*);
    static const auto get =
        reinterpret_cast<Get>(next(reinterpret_cast<const GLubyte*>("glGetInteger64v")));
    get(name, value);
}

}  // namespace

// Stands in the way of GLX's own function, which GLEW asks for OpenGL's.
extern "C" void (*glXGetProcAddressARB(const GLubyte* name))()
{
    if (std::strcmp(reinterpret_cast<const char*>(name), "glGetInteger64v") == 0)
        return reinterpret_cast<void (*)()>(get_integer);
    return next(name);
}
