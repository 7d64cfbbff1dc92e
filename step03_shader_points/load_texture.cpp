#include "step03_shader_points/load_texture.hpp"

#include <memory>
#include <stb_image.h>
#include <stdexcept>

#include "common/harness/files.hpp"

GlObject load_texture(const std::string& name)
{
    const std::string path = find_file(name).string();
    const auto refuse = [&](const std::string& reason) {
        throw std::runtime_error("cannot use " + path + ": " + reason);
    };
    const std::string broken = "a broken picture, or no PNG";  // stb does not always know why
    int width = 0, height = 0, channels = 0;
    if (!stbi_info(path.c_str(), &width, &height, &channels)) refuse(broken);
    GLint largest = 0;
    glGetIntegerv(GL_MAX_TEXTURE_SIZE, &largest);
    if (width > largest || height > largest) {
        refuse(std::to_string(width) + " x " + std::to_string(height) +
               " pixels, this card's textures end at " + std::to_string(largest) +
               " (make it smaller)");
    }
    stbi_set_flip_vertically_on_load(1);  // OpenGL's first row is the lowest
    const std::unique_ptr<stbi_uc, void (*)(void*)> pixels(
        stbi_load(path.c_str(), &width, &height, &channels, 4), stbi_image_free);
    if (!pixels) refuse(broken);

    GlObject texture = make_texture();
    glBindTexture(GL_TEXTURE_2D, texture);
    glTexImage2D(GL_TEXTURE_2D, 0, GL_RGBA8, width, height, 0, GL_RGBA, GL_UNSIGNED_BYTE,
                 pixels.get());
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_LINEAR_MIPMAP_LINEAR);
    glGenerateMipmap(GL_TEXTURE_2D);
    return texture;
}
