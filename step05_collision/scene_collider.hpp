// The scene as the update shader sees it: as voxels or as triangles.
#pragma once

#include <GL/glew.h>

#include <stdexcept>
#include <string>
#include <vector>

#include "common/program.hpp"
#include "common/scene.hpp"
#include "step05_collision/voxel_grid.hpp"

// Gives the program in use the grid's place in the world and, on texture unit 0, its voxels.
inline void set_voxels(Program& program, const VoxelGrid& grid, GLuint texture)
{
    program.set("voxels", 0);
    program.set("grid_origin", grid.origin);
    program.set("cell_size", grid.cell_size);
    program.set("resolution", grid.resolution);
    glBindTexture(GL_TEXTURE_3D, texture);
}

// All corners of all triangles in one long texture, 16 bytes each.
class TriangleTexture {
public:
    explicit TriangleTexture(const Scene& scene)
        : count_(int(scene.vertices.size() / 3)), buffer_(make_buffer()), texture_(make_texture())
    {
        GLint most = 0;
        glGetIntegerv(GL_MAX_TEXTURE_BUFFER_SIZE, &most);
        if (3 * count_ > most) {
            throw std::runtime_error("--variant triangles: this card's buffer textures hold " +
                                     std::to_string(most / 3) + " triangles, not " +
                                     std::to_string(count_));
        }
        std::vector<glm::vec4> corners;
        for (const Vertex& vertex : scene.vertices) corners.emplace_back(vertex.position, 1);
        glBindBuffer(GL_TEXTURE_BUFFER, buffer_);
        glBufferData(GL_TEXTURE_BUFFER, GLsizeiptr(corners.size() * sizeof(glm::vec4)),
                     corners.data(), GL_STATIC_DRAW);
        glBindTexture(GL_TEXTURE_BUFFER, texture_);
        glTexBuffer(GL_TEXTURE_BUFFER, GL_RGBA32F, buffer_);
    }

    // Gives them to the program in use, on texture unit 0.
    void set(Program& program) const
    {
        program.set("triangles", 0);
        program.set("triangle_count", count_);
        glBindTexture(GL_TEXTURE_BUFFER, texture_);
    }

private:
    int count_;
    GlObject buffer_, texture_;
};
