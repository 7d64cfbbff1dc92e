#include "step05_collision/triangle_texture.hpp"

#include <stdexcept>
#include <string>
#include <vector>

using glm::vec3;
using glm::vec4;

static void upload(GLuint buffer, GLuint texture, const std::vector<vec4>& texels)
{
    const auto bytes = GLsizeiptr(texels.size() * sizeof(vec4));
    glBindBuffer(GL_TEXTURE_BUFFER, buffer);
    glBufferData(GL_TEXTURE_BUFFER, bytes, texels.data(), GL_STATIC_DRAW);
    check_memory("the triangles", double(bytes));
    glBindTexture(GL_TEXTURE_BUFFER, texture);
    glTexBuffer(GL_TEXTURE_BUFFER, GL_RGBA32F, buffer);
}

TriangleTexture::TriangleTexture(const Scene& scene, bool boxed)
{
    GLint largest = 0;
    glGetIntegerv(GL_MAX_TEXTURE_BUFFER_SIZE, &largest);
    if (scene.indices.size() > size_t(largest)) {
        throw std::runtime_error("--variant triangles: this card's buffer textures hold " +
                                 std::to_string(largest / 3) + " triangles, not " +
                                 std::to_string(scene.indices.size() / 3));
    }
    std::vector<vec4> corners, boxes;
    const size_t box_corners = boxed ? 3 * 64 : scene.indices.size();
    for (size_t i = 0; i < scene.indices.size(); ++i) {
        const vec3 corner = scene.corner(i).position;
        if (i % box_corners == 0) {
            boxes.emplace_back(boxed ? corner : vec3(-INFINITY), i / 3);
            boxes.emplace_back(boxed ? corner : vec3(INFINITY), 0);
        }
        vec4 &low = boxes[boxes.size() - 2], &high = boxes.back();
        low = vec4(glm::min(vec3(low), corner), low.w);
        high = vec4(glm::max(vec3(high), corner), i / 3 + 1);
        corners.emplace_back(corner, 1);
    }
    upload(corners_, corner_texture_, corners);
    upload(boxes_, box_texture_, boxes);
}

void TriangleTexture::bind() const
{
    bind_texture(TRIANGLES_UNIT, GL_TEXTURE_BUFFER, corner_texture_);
    bind_texture(BOXES_UNIT, GL_TEXTURE_BUFFER, box_texture_);
}
