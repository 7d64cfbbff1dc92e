#include "step06_accumulation/winter/light/sky_visibility.hpp"

#include <GL/glew.h>

#include <algorithm>
#include <cmath>
#include <glm/gtc/constants.hpp>
#include <vector>

using glm::ivec3;
using glm::vec3;
using glm::vec4;

GlObject make_sky_visibility(const VoxelGrid& grid)
{
    const int cells = std::min(grid.resolution, 64), voxels = grid.resolution / cells;
    const auto cell_at = [](size_t index, size_t n) {
        return ivec3(int(index % n), int(index / n % n), int(index / n / n));
    };
    const auto index_of = [cells](ivec3 cell) {
        return (size_t(cell.z) * size_t(cells) + size_t(cell.y)) * size_t(cells) + size_t(cell.x);
    };
    // How much of the light that comes along is lost in each cell: all where a wall stands that is
    // one voxel thick.
    std::vector<float> opacity(index_of({0, 0, cells}));
    int top = 0;  // no layer from here on up holds anything
    for (size_t i = 0; i < 32 * grid.words.size(); ++i) {
        if (grid.words[i / 32] == 0) i += 31;
        if ((grid.words[i / 32] >> i % 32 & 1u) == 0) continue;
        const ivec3 cell = cell_at(i, size_t(grid.resolution)) / voxels;
        float& value = opacity[index_of(cell)];
        value = std::min(value + 1.0f / float(voxels * voxels), 1.0f);
        top = std::max(top, cell.y + 1);
    }
    // The fraction of the light that comes from the sky to `point`, in cells, along `direction`.
    const auto light_from = [&](vec3 direction, vec3 point) {
        float light = 1;
        while (light > 0.02f) {
            point += direction;
            const ivec3 cell(glm::floor(point));
            if (cell.y >= top || std::min(cell.x, cell.z) < 0 || std::max(cell.x, cell.z) >= cells)
                break;
            light *= 1 - opacity[index_of(cell)];
        }
        return light;
    };
    // Directions above the horizon, each for an equal share of the sky: a spiral that turns by the
    // golden angle from each to the next.
    vec3 sky[32];
    for (size_t i = 0; i < std::size(sky); ++i) {
        const float up = (float(i) + 0.5f) / std::size(sky), across = std::sqrt(1 - up * up);
        const float turn = float(i) * glm::pi<float>() * (3 - std::sqrt(5.0f));
        sky[i] = {across * std::cos(turn), up, across * std::sin(turn)};
    }

    // A surface that faces n receives from an even sky of brightness 1, which it sees in the
    // directions where v(d) is 1, very nearly: mean of v + 2 n . (mean of v d), the means over all
    // directions, with nothing from below (the first two bands of spherical harmonics: Ramamoorthi
    // and Hanrahan, "An efficient representation for irradiance environment maps", 2001).
    const vec4 open_sky(0, 0.5f, 0, 0.5f);  // the two means: 2 v d, -0.5 to 0.5, and v, 0 to 0.5
    const auto texel_of = [](vec4 means) { return vec4(0.5f + vec3(means), 2 * means.w); };
    std::vector<vec4> texels(opacity.size(), texel_of(open_sky));
    for (size_t i = 0; i < texels.size(); ++i) {
        const ivec3 cell = cell_at(i, size_t(cells));
        if (cell.y >= top) continue;
        // Where there is something in the cell, it is what lies on top of it that is seen.
        const vec3 point = vec3(cell) + vec3(0.5f, opacity[i] > 0 ? 1.0f : 0.5f, 0.5f);
        vec4 sum(0);
        for (const vec3 direction : sky)
            sum += light_from(direction, point) * vec4(2.0f * direction, 1);
        // 2: the sky is half of all directions
        texels[i] = texel_of(sum / (2.0f * std::size(sky)));
    }
    GlObject texture = make_texture();
    glBindTexture(GL_TEXTURE_3D, texture);
    // 8 bits a channel are enough for light so even, and what hardware filters fastest.
    glTexImage3D(GL_TEXTURE_3D, 0, GL_RGBA8, cells, cells, cells, 0, GL_RGBA, GL_FLOAT,
                 texels.data());
    glTexParameteri(GL_TEXTURE_3D, GL_TEXTURE_MIN_FILTER, GL_LINEAR);
    const vec4 border = texel_of(open_sky);
    glTexParameterfv(GL_TEXTURE_3D, GL_TEXTURE_BORDER_COLOR, &border.x);
    for (const GLenum wrap : {GL_TEXTURE_WRAP_S, GL_TEXTURE_WRAP_T, GL_TEXTURE_WRAP_R})
        glTexParameteri(GL_TEXTURE_3D, wrap, GL_CLAMP_TO_BORDER);
    return texture;
}
