#include "step03_shader_points/load_texture.hpp"

#include <stb_image.h>
#include <stdexcept>

#include "common/files.hpp"

Image read_picture(const std::filesystem::path& path)
{
    stbi_set_flip_vertically_on_load(1);  // OpenGL's first row is the lowest
    const std::string name = path.string();
    Image picture{0, 0, 0, {nullptr, stbi_image_free}};
    int &width = picture.width, &height = picture.height, &channels = picture.channels;
    // Its size is asked first: a small file can take gigabytes.
    if (stbi_info(name.c_str(), &width, &height, &channels) && width <= 8192 && height <= 8192)
        picture.pixels.reset(stbi_load(name.c_str(), &width, &height, &channels, 4));
    if (picture.pixels) return picture;
    throw std::runtime_error("cannot use " + name +
                             ": missing, broken, larger than 8192 x 8192 pixels, or no PNG, JPEG "
                             "or TGA (save it anew)");
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
