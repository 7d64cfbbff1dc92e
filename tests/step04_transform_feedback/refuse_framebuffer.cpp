// Loaded into a program with LD_PRELOAD, says of every framebuffer what a card may say of one whose
// format it cannot draw to.
#include <GL/glew.h>
#include <dlfcn.h>

#include <cstring>

namespace {

GLenum unsupported(GLenum)
{
    return GL_FRAMEBUFFER_UNSUPPORTED;
}

}  // namespace

// Stands in the way of GLX's own function, which GLEW asks for OpenGL's.
extern "C" void (*glXGetProcAddressARB(const GLubyte* name))()
{
    using Get = void (*(*)(const GLubyte*))();
    static const auto get = reinterpret_cast<Get>(dlsym(RTLD_NEXT, "glXGetProcAddressARB"));
    if (std::strcmp(reinterpret_cast<const char*>(name), "glCheckFramebufferStatus") == 0) {
        return reinterpret_cast<void (*)()>(unsupported);
    }
    return get(name);
}
