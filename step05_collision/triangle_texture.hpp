// The triangles of the scene as a shader sees them: all corners of all in one long texture, 16
// bytes each, and in another the boxes around them.
#pragma once

#include "common/bindings.glsl"
#include "common/gl_object.hpp"
#include "common/scene/scene.hpp"

class TriangleTexture {
public:
    // boxed: a box around every 64 triangles, in the order in which the scene holds them: by
    // material, and within one as in the file. Otherwise one box without ends around all. Throws
    // std::runtime_error if the card cannot hold them.
    TriangleTexture(const Scene& scene, bool boxed);

    // Hands them to the shaders (collide_triangles.glsl).
    void bind() const;

private:
    GlObject corners_ = make_buffer(), boxes_ = make_buffer();
    GlObject corner_texture_ = make_texture(), box_texture_ = make_texture();
};
