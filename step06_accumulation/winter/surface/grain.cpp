#include "step06_accumulation/winter/surface/grain.hpp"

#include <GL/glew.h>

#include <algorithm>
#include <vector>

#include "common/harness/driver.hpp"
#include "common/snow.hpp"

namespace {

constexpr int texels = 256;  // along each edge

// Uniform in [0, 1), one number for each knot of a net that repeats after `period` knots.
float knot(int x, int y, int period)
{
    const unsigned key = unsigned(y % period * period + x % period);
    return float(snow::hash(key ^ snow::hash(unsigned(period))) >> 8u) / 16777216.0f;
}

// Noise with `period` knots along each edge, smooth between them, -0.5 to 0.5.
float noise(int x, int y, int period)
{
    const int between = texels / period;
    const auto ease = [](float t) { return t * t * (3 - 2 * t); };
    const float u = ease(float(x % between) / float(between));
    const float v = ease(float(y % between) / float(between));
    const int i = x / between, j = y / between;
    return glm::mix(glm::mix(knot(i, j, period), knot(i + 1, j, period), u),
                    glm::mix(knot(i, j + 1, period), knot(i + 1, j + 1, period), u), v) -
           0.5f;
}

}  // namespace

GlObject make_grain()
{
    std::vector<float> height(texels * texels);
    const auto at = [&height](int x, int y) -> float& {
        return height[size_t(y + texels) % texels * texels + size_t(x + texels) % texels];
    };
    for (int y = 0; y < texels; ++y) {
        for (int x = 0; x < texels; ++x) {
            // Half as high for knots half as far apart: as steep at every size.
            for (int period = 32; period <= texels / 2; period *= 2)
                at(x, y) += noise(x, y, period) * 32.0f / float(period);
        }
    }
    std::vector<GLubyte> pixels;
    pixels.reserve(4 * height.size());
    const auto byte = [](float value) {
        return GLubyte(std::clamp(255 * value + 0.5f, 0.0f, 255.0f));
    };
    for (int y = 0; y < texels; ++y) {
        for (int x = 0; x < texels; ++x) {
            const float steep = 0.8f;
            const float lean_x = at(x + 1, y) - at(x - 1, y), lean_y = at(x, y + 1) - at(x, y - 1);
            for (const float value : {0.5f + steep * lean_x, 0.5f + steep * lean_y,
                                      0.5f + 0.5f * at(x, y), knot(x, y, texels)})
                pixels.push_back(byte(value));
        }
    }
    GlObject texture = make_texture();
    glBindTexture(GL_TEXTURE_2D, texture);
    glTexImage2D(GL_TEXTURE_2D, 0, GL_RGBA8, texels, texels, 0, GL_RGBA, GL_UNSIGNED_BYTE,
                 pixels.data());
    glGenerateMipmap(GL_TEXTURE_2D);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER,
                    renders_in_software() ? GL_LINEAR_MIPMAP_NEAREST : GL_LINEAR_MIPMAP_LINEAR);
    return texture;
}
