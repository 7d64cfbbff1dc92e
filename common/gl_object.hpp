// A handle that owns one OpenGL object: moved, not copied, and deleted with its scope. Declare
// handles after the Window, so that they go while its context still stands.
#pragma once

#include <GL/glew.h>

#include <utility>

class GlObject {
public:
    using Remove = void(GLAPIENTRY*)(GLsizei count, const GLuint* ids);

    GlObject() = default;
    GlObject(GLuint id, Remove remove) : id_(id), remove_(remove) {}
    GlObject(void(GLAPIENTRY* generate)(GLsizei count, GLuint* ids), Remove remove)
        : remove_(remove)
    {
        generate(1, &id_);
    }
    GlObject(GlObject&& other) noexcept { *this = std::move(other); }
    GlObject& operator=(GlObject&& other) noexcept
    {
        std::swap(id_, other.id_);
        std::swap(remove_, other.remove_);
        return *this;
    }
    ~GlObject()
    {
        if (id_ != 0) remove_(1, &id_);
    }
    operator GLuint() const { return id_; }

private:
    GLuint id_ = 0;
    Remove remove_ = nullptr;
};

inline GlObject make_buffer()
{
    return {glGenBuffers, glDeleteBuffers};
}

inline GlObject make_vertex_array()
{
    return {glGenVertexArrays, glDeleteVertexArrays};
}

inline GlObject make_texture()
{
    return {glGenTextures, glDeleteTextures};
}

inline GlObject make_framebuffer()
{
    return {glGenFramebuffers, glDeleteFramebuffers};
}

// Binds a texture to a unit of bindings.glsl, at which a shader's layout(binding = ...) finds it.
inline void bind_texture(GLuint unit, GLenum target, GLuint texture)
{
    glActiveTexture(GL_TEXTURE0 + unit);
    glBindTexture(target, texture);
}

// To be called after a large allocation: throws std::runtime_error if OpenGL had no memory for it,
// or has met any other error since it was last asked.
void check_memory(const char* what, double bytes);

// The same of the framebuffer that is bound: throws if this card cannot draw to what is attached.
void check_framebuffer(const char* what);

// The same after reading back: throws if OpenGL has not delivered.
void check_read_back(const char* what);
