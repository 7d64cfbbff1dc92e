// For draws whose shaders make their vertices up, from gl_VertexID alone.
#pragma once

#include <GL/glew.h>

#include "common/gl_object.hpp"

// A vertex array with nothing in it but a zero, as attribute 0 of all vertices: in a compatibility
// context, where attribute 0 is what glVertex once was, a driver may draw nothing without it.
class NoVertices {
public:
    NoVertices() : buffer_(make_buffer()), vao_(make_vertex_array())
    {
        const GLfloat zero = 0;
        const GLuint all = 1 << 20;  // so many instances share the one value
        glBindVertexArray(vao_);
        glBindBuffer(GL_ARRAY_BUFFER, buffer_);
        glBufferData(GL_ARRAY_BUFFER, sizeof zero, &zero, GL_STATIC_DRAW);
        glEnableVertexAttribArray(0);
        glVertexAttribPointer(0, 1, GL_FLOAT, GL_FALSE, 0, nullptr);
        glVertexAttribDivisor(0, all);
    }
    operator GLuint() const { return vao_; }

private:
    GlObject buffer_, vao_;
};
