// A handle that owns one OpenGL object: moved, not copied, and deleted with its scope. Declare
// handles after the Window, so that they go while its context still stands.
#pragma once

#include <GL/glew.h>

#include <utility>

class GlObject {
public:
    GlObject() = default;
    GlObject(GLuint id, void (*remove)(GLuint)) : id_(id), remove_(remove) {}
    GlObject(GlObject&& other) noexcept { swap(other); }
    GlObject& operator=(GlObject&& other) noexcept
    {
        swap(other);
        return *this;
    }
    ~GlObject()
    {
        if (id_ != 0) remove_(id_);
    }
    operator GLuint() const { return id_; }

private:
    void swap(GlObject& other)
    {
        std::swap(id_, other.id_);
        std::swap(remove_, other.remove_);
    }
    GLuint id_ = 0;
    void (*remove_)(GLuint) = nullptr;
};

// To be called after a large allocation. Throws std::runtime_error if OpenGL had no memory for it.
void check_memory(const char* what, double bytes);

// To be called with a framebuffer bound that is complete now. Throws std::runtime_error if this card
// cannot draw to what is attached.
void check_framebuffer(const char* what);

// To be called after reading back. Throws std::runtime_error if OpenGL has not delivered.
void check_read_back(const char* what);

inline GlObject make_buffer()
{
    GLuint id = 0;
    glGenBuffers(1, &id);
    return {id, [](GLuint buffer) { glDeleteBuffers(1, &buffer); }};
}

inline GlObject make_vertex_array()
{
    GLuint id = 0;
    glGenVertexArrays(1, &id);
    return {id, [](GLuint vao) { glDeleteVertexArrays(1, &vao); }};
}

inline GlObject make_texture()
{
    GLuint id = 0;
    glGenTextures(1, &id);
    return {id, [](GLuint texture) { glDeleteTextures(1, &texture); }};
}

inline GlObject make_framebuffer()
{
    GLuint id = 0;
    glGenFramebuffers(1, &id);
    return {id, [](GLuint framebuffer) { glDeleteFramebuffers(1, &framebuffer); }};
}

inline GlObject make_renderbuffer()
{
    GLuint id = 0;
    glGenRenderbuffers(1, &id);
    return {id, [](GLuint renderbuffer) { glDeleteRenderbuffers(1, &renderbuffer); }};
}

// Binds a texture to a unit of bindings.glsl, at which a shader's layout(binding = ...) finds it.
inline void bind_texture(GLuint unit, GLenum target, GLuint texture)
{
    glActiveTexture(GL_TEXTURE0 + unit);
    glBindTexture(target, texture);
}
