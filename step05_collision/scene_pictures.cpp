#include "step05_collision/scene_pictures.hpp"

#include <algorithm>
#include <iostream>
#include <stdexcept>

#include "common/harness/driver.hpp"
#include "step03_shader_points/load_texture.hpp"

namespace {

// Puts the mask into the alpha of the picture, where 0 is cut out. The two may differ in size.
void cut_out(Image& picture, const Image& mask)
{
    const int channel = mask.channels % 2 == 0 ? 3 : 0;  // its alpha if it has that
    for (int y = 0; y < picture.height; ++y) {
        for (int x = 0; x < picture.width; ++x) {
            const int row = y * mask.height / picture.height,
                      column = x * mask.width / picture.width;
            picture.pixels.get()[4 * (y * picture.width + x) + 3] =
                mask.pixels.get()[4 * (row * mask.width + column) + channel];
        }
    }
}

GlObject upload(const Material& material)
{
    Image picture = read_picture(material.picture.empty() ? material.mask : material.picture);
    if (material.picture.empty())
        std::fill_n(picture.pixels.get(), 4 * picture.width * picture.height, 255);
    // A mask that is the picture itself means the alpha that this has already.
    if (!material.mask.empty() && material.mask != material.picture)
        cut_out(picture, read_picture(material.mask));
    GlObject texture = upload_picture(picture);
    check_memory("the pictures", 4.0 * picture.width * picture.height);
    if (renders_in_software()) {  // each texel that is read takes its time: half as many
        glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_LINEAR_MIPMAP_NEAREST);
    } else if (GLEW_EXT_texture_filter_anisotropic) {
        // Seen at a flat angle, a pixel covers a long strip of the picture: its average.
        glTexParameterf(GL_TEXTURE_2D, GL_TEXTURE_MAX_ANISOTROPY_EXT, 8);
    }
    return texture;
}

}  // namespace

ScenePictures::ScenePictures(const Scene& scene)
{
    GLubyte white[4] = {255, 255, 255, 255};
    white_ = upload_picture({1, 1, 4, {white, [](void*) {}}});
    for (const Submesh& submesh : scene.submeshes) of_submesh_.push_back(load(submesh.material));
    of_submesh_.push_back(white_);
}

GLuint ScenePictures::load(const Material& material)
{
    if (material.picture.empty() && material.mask.empty()) return white_;
    const auto [texture, is_new] = loaded_.try_emplace({material.picture, material.mask});
    if (is_new) {
        try {
            texture->second = upload(material);
        } catch (const std::runtime_error& error) {
            std::cerr << "warning: " << error.what() << "; one colour takes its place" << std::endl;
        }
    }
    return texture->second != 0 ? texture->second : white_;
}

void ScenePictures::set(Program& program, size_t submesh) const
{
    program.set_texture("picture", PICTURE_UNIT, GL_TEXTURE_2D, of_submesh_[submesh]);
}
