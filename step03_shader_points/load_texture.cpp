#include "step03_shader_points/load_texture.hpp"

#include <stb_image.h>
#include <stdexcept>

#include "common/files.hpp"

Image read_picture(const std::filesystem::path& path)
{
    const std::string name = path.string();
    const auto refuse = [&](const std::string& reason) {
        throw std::runtime_error("cannot use " + name + ": " + reason);
    };
    // stb does not always know why.
    const std::string broken = "missing, broken, or no PNG, JPEG or TGA (save it anew)";
    int width = 0, height = 0, channels = 0;
    if (!stbi_info(name.c_str(), &width, &height, &channels)) refuse(broken);
    if (width > 8192 || height > 8192) {  // which could take gigabytes
        refuse(std::to_string(width) + " x " + std::to_string(height) +
               " pixels, at most 8192 x 8192 can be used (make it smaller)");
    }
    stbi_set_flip_vertically_on_load(1);  // OpenGL's first row is the lowest
    Image picture{0, 0, 0, {nullptr, stbi_image_free}};
    picture.pixels.reset(
        stbi_load(name.c_str(), &picture.width, &picture.height, &picture.channels, 4));
    if (!picture.pixels) refuse(broken);
    return picture;
}

GlObject upload_picture(const Image& picture)
{
    GlObject texture = make_texture();
    glBindTexture(GL_TEXTURE_2D, texture);
    glTexImage2D(GL_TEXTURE_2D, 0, GL_RGBA8, picture.width, picture.height, 0, GL_RGBA,
                 GL_UNSIGNED_BYTE, picture.pixels.get());
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_LINEAR_MIPMAP_LINEAR);
    glGenerateMipmap(GL_TEXTURE_2D);
    return texture;
}

GlObject load_texture(const std::string& name)
{
    return upload_picture(read_picture(find_file(name)));
}
