// The frame while it is drawn: light, linear and as bright as it is, not yet colours of a screen.
#pragma once

#include <GL/glew.h>

#include <glm/glm.hpp>

#include "common/gl_object.hpp"

class HdrTarget {
public:
    // All that follows is drawn into it. Clears it to `background`. size: of the window, pixels.
    // multisample: four samples a pixel.
    void begin(glm::ivec2 size, bool multisample, glm::vec3 background);

    // All is drawn that has edges. What had several samples a pixel has one from here on, and what
    // follows is blended over it.
    void resolve() const;

    GLuint colour() const { return colour_; }  // a texture, whose mipmaps are yet to be made

private:
    void allocate();
    void add_renderbuffer(GLenum attachment, GLenum format, int samples, GlObject& buffer);

    glm::ivec2 size_{};
    bool multisample_ = false;
    GlObject colour_, depth_, framebuffer_;
    GlObject samples_colour_, samples_depth_, samples_framebuffer_;  // where there are several
};
