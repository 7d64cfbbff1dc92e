// The frame while it is drawn: light, linear and as bright as it is, not yet colours of a screen.
#pragma once

#include <GL/glew.h>

#include <glm/glm.hpp>
#include <vector>

#include "common/gl_object.hpp"
#include "common/weather.hpp"

class LinearFrame {
public:
    static std::vector<snow::Parameter> parameters();
    inline static bool multisample = true;

    // All that follows is drawn into it. Clears it to `background`. size: of the window, pixels.
    void begin(glm::ivec2 size, glm::vec3 background);

    // All edges are drawn: what had several samples a pixel has one from here on. What follows is
    // blended over it, and may read how deep it is.
    void end_edges();

    // What follows does not see how deep it is, but may read it.
    void detach_depth() const;
    void attach_depth() const;

    // All that follows is drawn into the window.
    void end() const;

    GLuint colour() const { return colour_; }
    GLuint depth() const { return depth_; }
    glm::ivec2 size() const { return size_; }

private:
    void allocate(int samples);

    glm::ivec2 size_{};
    int samples_ = 0;  // a pixel, of what edges are drawn into
    GlObject colour_, depth_, framebuffer_, colours_only_;
    GlObject many_colours_, many_depths_, many_framebuffer_;  // where there are several
};
