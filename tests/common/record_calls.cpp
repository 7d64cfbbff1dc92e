// Loaded into a program with LD_PRELOAD, writes some of its calls of OpenGL to the file that
// CALLS_FILE names, in their order: a line for each, its name and its numbers.
#include <GL/glew.h>
#include <dlfcn.h>

#include <cstdio>
#include <cstdlib>
#include <initializer_list>
#include <string_view>

namespace {

using Function = void (*)();

// OpenGL's own function, not the one below.
Function opengl(const char* name)
{
    using Get = Function (*)(const GLubyte*);
    static const auto get = reinterpret_cast<Get>(dlsym(RTLD_NEXT, "glXGetProcAddressARB"));
    return get(reinterpret_cast<const GLubyte*>(name));
}

void record(const char* name, std::initializer_list<long long> numbers)
{
    static std::FILE* const file = std::fopen(std::getenv("CALLS_FILE"), "w");
    std::fputs(name, file);
    for (const long long number : numbers) std::fprintf(file, " %lld", number);
    std::fputc('\n', file);
}

void buffer_data(GLenum target, GLsizeiptr bytes, const void* data, GLenum usage)
{
    record("glBufferData", {target, bytes, usage});
    static const auto call = reinterpret_cast<decltype(&buffer_data)>(opengl("glBufferData"));
    call(target, bytes, data, usage);
}

void read_buffer(GLenum target, GLintptr offset, GLsizeiptr bytes, void* data)
{
    record("glGetBufferSubData", {target, offset, bytes});
    static const auto call = reinterpret_cast<decltype(&read_buffer)>(opengl("glGetBufferSubData"));
    call(target, offset, bytes, data);
}

void dispatch(GLuint x, GLuint y, GLuint z)
{
    record("glDispatchCompute", {x, y, z});
    static const auto call = reinterpret_cast<decltype(&dispatch)>(opengl("glDispatchCompute"));
    call(x, y, z);
}

void barrier(GLbitfield bits)
{
    record("glMemoryBarrier", {bits});
    static const auto call = reinterpret_cast<decltype(&barrier)>(opengl("glMemoryBarrier"));
    call(bits);
}

}  // namespace

// These two stand in the way of the functions that a program is linked with: a draw, of which is
// told, too, whether an array feeds attribute 0; and GLX's own, which GLEW asks for all that is
// newer than OpenGL 1.1.
extern "C" void glDrawArrays(GLenum mode, GLint first, GLsizei number)
{
    using Get = void (*)(GLuint, GLenum, GLint*);
    static const auto get = reinterpret_cast<Get>(opengl("glGetVertexAttribiv"));
    static const auto call = reinterpret_cast<decltype(&glDrawArrays)>(opengl("glDrawArrays"));
    GLint fed = glIsEnabled(GL_VERTEX_ARRAY);  // of older shaders
    if (!fed) get(0, GL_VERTEX_ATTRIB_ARRAY_ENABLED, &fed);
    record("glDrawArrays", {mode, first, number, fed});
    call(mode, first, number);
}

extern "C" Function glXGetProcAddressARB(const GLubyte* name)
{
    const std::string_view wanted(reinterpret_cast<const char*>(name));
    if (wanted == "glBufferData") return reinterpret_cast<Function>(buffer_data);
    if (wanted == "glGetBufferSubData") return reinterpret_cast<Function>(read_buffer);
    if (wanted == "glDispatchCompute") return reinterpret_cast<Function>(dispatch);
    if (wanted == "glMemoryBarrier") return reinterpret_cast<Function>(barrier);
    return opengl(reinterpret_cast<const char*>(name));
}
