#include "step05_collision/triangle_texture.hpp"

#include <stdexcept>
#include <string>
#include <vector>

TriangleTexture::TriangleTexture(const Scene& scene)
    : buffer_(make_buffer()), texture_(make_texture())
{
    GLint largest = 0;
    glGetIntegerv(GL_MAX_TEXTURE_BUFFER_SIZE, &largest);
    if (scene.indices.size() > size_t(largest)) {
        throw std::runtime_error("--variant triangles: this card's buffer textures hold " +
                                 std::to_string(largest / 3) + " triangles, not " +
                                 std::to_string(scene.indices.size() / 3));
    }
    std::vector<glm::vec4> corners;
    for (size_t i = 0; i < scene.indices.size(); ++i)
        corners.emplace_back(scene.corner(i).position, 1);
    glBindBuffer(GL_TEXTURE_BUFFER, buffer_);
    glBufferData(GL_TEXTURE_BUFFER, GLsizeiptr(corners.size() * sizeof(glm::vec4)), corners.data(),
                 GL_STATIC_DRAW);
    check_memory("the triangles", double(corners.size() * sizeof(glm::vec4)));
    glBindTexture(GL_TEXTURE_BUFFER, texture_);
    glTexBuffer(GL_TEXTURE_BUFFER, GL_RGBA32F, buffer_);
}
