// The triangles of the scene as a shader sees them: all corners of all in one long texture, 16
// bytes each.
#pragma once

#include "common/bindings.glsl"
#include "common/gl_object.hpp"
#include "common/scene/scene.hpp"

class TriangleTexture {
public:
    // Throws std::runtime_error if the card cannot hold them.
    explicit TriangleTexture(const Scene& scene);

    // Hands them to the shaders (collide_triangles.glsl).
    void bind() const { bind_texture(TRIANGLES_UNIT, GL_TEXTURE_BUFFER, texture_); }

private:
    GlObject buffer_, texture_;
};
