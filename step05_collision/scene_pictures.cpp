#include "step05_collision/scene_pictures.hpp"

#include <algorithm>
#include <iostream>
#include <stdexcept>

#include "common/harness/driver.hpp"
#include "common/harness/progress.hpp"
#include "step03_shader_points/load_texture.hpp"

namespace {

// Puts the mask into the alpha of the picture, in which 0 is cut out. It may have fewer pixels, or
// more.
void cut_out(Image& picture, const Image& mask)
{
    const int channel = mask.channels % 2 == 0 ? 3 : 0;  // its alpha if it has that
    for (int y = 0; y < picture.height; ++y) {
        const auto row = size_t(int64_t(y) * mask.height / picture.height) * size_t(mask.width);
        for (int x = 0; x < picture.width; ++x) {
            const auto column = size_t(int64_t(x) * mask.width / picture.width);
            const auto pixel = size_t(y) * size_t(picture.width) + size_t(x);
            picture.pixels.get()[4 * pixel + 3] =
                mask.pixels.get()[4 * (row + column) + size_t(channel)];
        }
    }
}

// White, and of the mask's shape.
Image white_of(const Material& material)
{
    Image picture = read_picture(material.mask);
    const size_t pixels = size_t(picture.width) * size_t(picture.height);
    std::fill_n(picture.pixels.get(), 4 * pixels, static_cast<unsigned char>(255));
    return picture;
}

GlObject upload(const Material& material)
{
    Image picture = material.picture.empty() ? white_of(material) : read_picture(material.picture);
    if (!material.mask.empty()) cut_out(picture, read_picture(material.mask));
    GlObject texture = upload_picture(picture);
    check_memory("the pictures", 4.0 * picture.width * picture.height);
    if (renders_in_software()) {  // each texel that is read takes its time: half as many
        glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_LINEAR_MIPMAP_NEAREST);
    } else if (has_extension("GL_EXT_texture_filter_anisotropic")) {
        // Seen at a flat angle, a pixel covers a long strip of the picture: its average.
        glTexParameterf(GL_TEXTURE_2D, GL_TEXTURE_MAX_ANISOTROPY_EXT, 8);
    }
    return texture;
}

GlObject make_one_colour(glm::vec3 colour)
{
    GlObject texture = make_texture();
    glBindTexture(GL_TEXTURE_2D, texture);
    glTexImage2D(GL_TEXTURE_2D, 0, GL_RGB8, 1, 1, 0, GL_RGB, GL_FLOAT, &colour[0]);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
    return texture;
}

}  // namespace

ScenePictures::ScenePictures(const Scene& scene)
    : white_(make_one_colour(glm::vec3(1))),
      grey_(make_one_colour(glm::sqrt(Material{}.colour)))  // which picture.glsl squares
{
    {
        Progress progress("loading pictures");
        for (const Submesh& submesh : scene.submeshes) {
            if (progress.due())
                progress.report(double(of_submesh_.size()) / double(scene.submeshes.size()));
            of_submesh_.push_back(load(submesh.material));
        }
    }
    of_submesh_.push_back(white_);
    std::cerr << warnings_ << std::flush;  // below the line of the progress
}

GLuint ScenePictures::load(const Material& material)
{
    if (!material.has_picture()) return white_;
    const auto [place, is_new] = loaded_.try_emplace({material.picture, material.mask});
    if (is_new) {
        try {
            place->second = upload(material);
        } catch (const std::runtime_error& error) {
            warnings_ += "warning: " + std::string(error.what()) + "; one colour takes its place\n";
        }
    }
    if (place->second != 0) return place->second;
    // What is drawn is this times the material's tint. That is white instead of a black Kd, but
    // without the picture it should be grey.
    return material.picture.empty() || material.tint == material.colour ? white_ : grey_;
}

void ScenePictures::set(Program& program, size_t submesh) const
{
    program.set_texture("picture", PICTURE_UNIT, GL_TEXTURE_2D, of_submesh_[submesh]);
}
