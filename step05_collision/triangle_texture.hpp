// The triangles of the scene as a shader sees them: all corners of all in one long texture, 16
// bytes each.
#pragma once

#include "common/program.hpp"
#include "common/scene/scene.hpp"

class TriangleTexture {
public:
    // Throws std::runtime_error if the card cannot hold them.
    explicit TriangleTexture(const Scene& scene);

    // Gives them to the program in use.
    void set(Program& program) const;

private:
    int count_;
    GlObject buffer_, texture_;
};
