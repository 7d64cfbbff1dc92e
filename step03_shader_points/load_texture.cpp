#include "step03_shader_points/load_texture.hpp"

#include <memory>
#include <stb/stb_image.h>
#include <stdexcept>

#include "common/harness/files.hpp"

GlObject load_texture(const std::string& name)
{
    const std::string path = find_file(name).string();
    int width = 0, height = 0, channels = 0;
    stbi_set_flip_vertically_on_load(1);  // OpenGL's first row is the lowest
    const std::unique_ptr<stbi_uc, void (*)(void*)> pixels(
        stbi_load(path.c_str(), &width, &height, &channels, 4), stbi_image_free);
    if (!pixels)
        throw std::runtime_error("cannot use " + path + ": " + stbi_failure_reason() +
                                 " (not a PNG?)");

    GlObject texture = make_texture();
    glBindTexture(GL_TEXTURE_2D, texture);
    glTexImage2D(GL_TEXTURE_2D, 0, GL_RGBA8, width, height, 0, GL_RGBA, GL_UNSIGNED_BYTE,
                 pixels.get());
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_LINEAR_MIPMAP_LINEAR);
    glGenerateMipmap(GL_TEXTURE_2D);
    return texture;
}
