#include "step06_accumulation/winter/light/sky_visibility.hpp"

#include <GL/glew.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/gtc/constants.hpp>
#include <vector>

namespace {

using glm::ivec3;
using glm::vec3;
using glm::vec4;

constexpr int most_cells = 64;  // along each edge of the grid's cube
constexpr int directions = 32;  // evenly spread over the sky

// How much of the light that comes along is lost in each cell, which is several voxels wide.
struct Opacity {
    int cells;  // along each edge of the cube
    int top;    // no layer from here on up holds anything
    std::vector<float> values;

    size_t index(ivec3 cell) const
    {
        return (size_t(cell.z) * size_t(cells) + size_t(cell.y)) * size_t(cells) + size_t(cell.x);
    }

    // The fraction of the light that comes from the sky to `point`, in cells, along `direction`.
    float light_from(vec3 direction, vec3 point) const
    {
        float light = 1;
        while (light > 0.02f) {
            point += direction;
            const ivec3 cell(glm::floor(point));
            if (cell.y >= top || std::min(cell.x, cell.z) < 0 || std::max(cell.x, cell.z) >= cells)
                break;
            light *= 1 - values[index(cell)];
        }
        return light;
    }
};

Opacity opacity_of(const VoxelGrid& grid)
{
    Opacity opacity{std::min(grid.resolution, most_cells), 0, {}};
    opacity.values.resize(opacity.index({0, 0, opacity.cells}));
    const int voxels = grid.resolution / opacity.cells;  // along each edge of a cell
    for (size_t i = 0; i < 32 * grid.words.size(); ++i) {
        if (grid.words[i / 32] == 0) i += 31;
        if ((grid.words[i / 32] >> i % 32 & 1u) == 0) continue;
        const size_t n = size_t(grid.resolution);
        const ivec3 cell = ivec3(int(i % n), int(i / n % n), int(i / n / n)) / voxels;
        // A wall one voxel thick is to hold back all of the light.
        float& value = opacity.values[opacity.index(cell)];
        value = std::min(value + 1.0f / float(voxels * voxels), 1.0f);
        opacity.top = std::max(opacity.top, cell.y + 1);
    }
    return opacity;
}

}  // namespace

GlObject make_sky_visibility(const VoxelGrid& grid)
{
    const Opacity opacity = opacity_of(grid);
    // Directions above the horizon, each for an equal share of the sky: a spiral that turns by the
    // golden angle from each to the next.
    std::array<vec3, directions> sky;
    for (int i = 0; i < directions; ++i) {
        const float up = (float(i) + 0.5f) / directions, across = std::sqrt(1 - up * up);
        const float turn = float(i) * glm::pi<float>() * (3 - std::sqrt(5.0f));
        sky[size_t(i)] = {across * std::cos(turn), up, across * std::sin(turn)};
    }

    // A surface that faces n receives from an even sky of brightness 1, which it sees in the
    // directions where v(d) is 1, very nearly: mean of v + 2 n . (mean of v d), the means over all
    // directions, with nothing from below (the first two bands of spherical harmonics: Ramamoorthi
    // and Hanrahan, "An efficient representation for irradiance environment maps", 2001).
    const vec4 open_sky(0, 0.5f, 0, 0.5f);  // the two means: 2 v d, -0.5 to 0.5, and v, 0 to 0.5
    const auto texel_of = [](vec4 means) { return vec4(0.5f + vec3(means), 2 * means.w); };
    std::vector<vec4> texels(opacity.values.size(), texel_of(open_sky));
    for (int z = 0; z < opacity.cells; ++z) {
        for (int y = 0; y < opacity.top; ++y) {
            for (int x = 0; x < opacity.cells; ++x) {
                const size_t cell = opacity.index({x, y, z});
                // Where there is something in the cell, it is what lies on top of it that is seen.
                const float height = opacity.values[cell] > 0 ? 1.0f : 0.5f;
                const vec3 point = vec3(x, y, z) + vec3(0.5f, height, 0.5f);
                vec4 sum(0);
                for (const vec3 direction : sky) {
                    sum += opacity.light_from(direction, point) * vec4(2.0f * direction, 1);
                }
                // 2: the sky is half of all directions
                texels[cell] = texel_of(sum / (2.0f * directions));
            }
        }
    }

    GlObject texture = make_texture();
    glBindTexture(GL_TEXTURE_3D, texture);
    // 8 bits a channel are enough for light so even, and what hardware filters fastest.
    glTexImage3D(GL_TEXTURE_3D, 0, GL_RGBA8, opacity.cells, opacity.cells, opacity.cells, 0,
                 GL_RGBA, GL_FLOAT, texels.data());
    glTexParameteri(GL_TEXTURE_3D, GL_TEXTURE_MIN_FILTER, GL_LINEAR);
    const vec4 border = texel_of(open_sky);
    glTexParameterfv(GL_TEXTURE_3D, GL_TEXTURE_BORDER_COLOR, &border.x);
    for (const GLenum wrap : {GL_TEXTURE_WRAP_S, GL_TEXTURE_WRAP_T, GL_TEXTURE_WRAP_R}) {
        glTexParameteri(GL_TEXTURE_3D, wrap, GL_CLAMP_TO_BORDER);
    }
    return texture;
}
