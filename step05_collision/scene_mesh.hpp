// A scene on the GPU, to be drawn: attributes 0 to 3 are the fields of Vertex.
#pragma once

#include "common/gl_object.hpp"
#include "common/scene/scene.hpp"

class SceneMesh {
public:
    explicit SceneMesh(const Scene& scene);

    // Draws all of it.
    void draw() const;

    // Draws one of its submeshes.
    void draw(const Submesh& submesh) const;

private:
    GlObject vertices_, indices_, vao_;
    GLsizei count_;  // of the indices
};
