#include "step06_accumulation/winter/surface/grain.hpp"

#include <GL/glew.h>

#include <glm/gtc/noise.hpp>
#include <vector>

#include "common/harness/driver.hpp"

GlObject make_grain()
{
    constexpr int texels = 256;  // along each edge
    std::vector<glm::vec4> pixels;
    for (int i = 0; i < texels * texels; ++i) {
        // Three noises that have nothing to do with each other, each of three sizes.
        glm::vec4 noise(0);
        for (float knots = 32; knots <= 128; knots *= 2) {
            const glm::vec2 place =
                knots / float(texels) * (glm::vec2(i % texels, i / texels) + 0.5f);
            for (int channel = 0; channel < 3; ++channel) {
                noise[channel] +=
                    0.2f * glm::perlin(glm::vec3(place, 0.5f + float(channel)), glm::vec3(knots));
            }
        }
        pixels.push_back(0.5f + noise);
    }
    GlObject texture = make_texture();
    glBindTexture(GL_TEXTURE_2D, texture);
    glTexImage2D(GL_TEXTURE_2D, 0, GL_RGBA8, texels, texels, 0, GL_RGBA, GL_FLOAT, pixels.data());
    glGenerateMipmap(GL_TEXTURE_2D);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER,
                    renders_in_software() ? GL_LINEAR_MIPMAP_NEAREST : GL_LINEAR_MIPMAP_LINEAR);
    return texture;
}
