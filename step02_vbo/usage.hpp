// What the program tells the driver about a buffer that it is going to fill: --hint. It is no more
// than that: any buffer may be used in any way, and a driver may believe what it likes.
#pragma once

#include <GL/glew.h>

#include <string>

inline GLenum usage(const std::string& hint)
{
    if (hint == "static") return GL_STATIC_DRAW;    // written once, drawn often
    if (hint == "dynamic") return GL_DYNAMIC_DRAW;  // written again and again, drawn often
    return GL_STREAM_DRAW;                          // written once for every time it is drawn or so
}
