// The walk of a flake through the voxels, in both its languages: as C++, and in a window of its own
// as GLSL. Every way here begins and ends within a rounding error of a face between two cells.
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <random>

#include "common/harness/harness.hpp"
#include "common/uniform_block.hpp"
#include "common/weather.hpp"
#include "common/window.hpp"
#include "step05_collision/solid_scene.hpp"

using glm::ivec3;
using glm::vec3;

namespace snow {

VoxelGrid grid;

bool solid(ivec3 cell)
{
    return grid.solid(cell);
}

#include "step05_collision/voxel_walk.glsl"

}  // namespace snow

namespace {

struct Way {
    vec3 from;
    float unused;
    snow::Particle flake;  // that has just moved
};

float ulps_from(float value, int ulps)
{
    const float towards = ulps > 0 ? INFINITY : -INFINITY;
    for (int n = 0; n < std::abs(ulps); ++n) value = std::nextafter(value, towards);
    return value;
}

class Walk : public testing::Test {
protected:
    Walk()
    {
        // As voxelise() places it: the upper sides of the lowest cells are the ground, y = 0.
        grid.resolution = 32;
        grid.cell_size = 16.0f / 30;
        grid.origin = vec3(-16 * grid.cell_size, -0.999f * grid.cell_size, -16 * grid.cell_size);
        grid.words.resize(32 * 32);
    }

    static CommandLine command()
    {
        std::vector<std::string> words = {"walk_test", "--size", "64x64"};
        std::vector<char*> argv;
        for (std::string& word : words) argv.push_back(word.data());
        return parse_command_line(int(argv.size()), argv.data(),
                                  {.name = "walk_test",
                                   .idea = "a test",
                                   .minimum_gl = 4.3,
                                   .variants = {{"voxels", nullptr}}});
    }

    float random(float least, float most)
    {
        return std::uniform_real_distribution<float>(least, most)(generator);
    }

    // Across every face between two cells, from either side, or up to it: from -3 to 3 ulps off the
    // face to -3 to 3 ulps off, and along the other axes as far as `reach` cells.
    std::vector<Way> ways_across_faces(float reach)
    {
        std::vector<Way> ways;
        for (int axis = 0; axis < 3; ++axis) {
            for (int face = axis == 1 ? 1 : 0; face <= 32; ++face) {
                for (int begin = -3; begin <= 3; ++begin) {
                    for (int end = -3; end <= 3; ++end) {
                        const vec3 cells(random(0, 32), random(1, 32), random(0, 32));
                        vec3 from = grid.origin + grid.cell_size * cells;
                        vec3 to = from + grid.cell_size * vec3(random(-reach, reach),
                                                               random(-reach, reach),
                                                               random(-reach, reach));
                        const float place = grid.origin[axis] + grid.cell_size * float(face);
                        from[axis] = ulps_from(place, begin);
                        to[axis] = ulps_from(place, end);
                        if (grid.solid(ivec3(floor((from - grid.origin) / grid.cell_size))))
                            continue;
                        const vec3 velocity = (to - from) / weather.time_step;
                        // Like an update, which lets a flake settle on the ground first.
                        ways.push_back(
                            {from, 0, snow::settle({to, 1.0f, velocity, 0.0f}, weather)});
                    }
                }
            }
        }
        return ways;
    }

    std::vector<snow::Particle> walk_in_cpp(const std::vector<Way>& ways)
    {
        snow::grid = grid;
        std::vector<snow::Particle> flakes;
        for (const Way& way : ways) flakes.push_back(snow::collide(way.from, way.flake, weather));
        return flakes;
    }

    std::vector<snow::Particle> walk_in_glsl(std::vector<Way> ways)
    {
        UniformBlock<snow::Weather> weather_block;
        weather_block.update(WEATHER_BLOCK, weather);
        const GlObject voxels = upload_voxels(grid), buffer = make_buffer();
        const GLsizeiptr bytes = GLsizeiptr(ways.size() * sizeof(Way));
        glBindBufferBase(GL_SHADER_STORAGE_BUFFER, 0, buffer);
        glBufferData(GL_SHADER_STORAGE_BUFFER, bytes, ways.data(), GL_DYNAMIC_COPY);
        program.use();
        UniformBlock<snow::Grid> block;
        block.update(GRID_BLOCK, {grid.origin, grid.cell_size, grid.resolution, 0, 0, 0});
        bind_texture(VOXELS_UNIT, GL_TEXTURE_3D, voxels);
        glDispatchCompute(GLuint(ways.size() + 63) / 64, 1, 1);
        glMemoryBarrier(GL_BUFFER_UPDATE_BARRIER_BIT);
        glGetBufferSubData(GL_SHADER_STORAGE_BUFFER, 0, bytes, ways.data());
        std::vector<snow::Particle> flakes;
        for (const Way& way : ways) flakes.push_back(way.flake);
        return flakes;
    }

    std::mt19937 generator{1};
    VoxelGrid grid{};
    const snow::Weather weather = snow::make_weather("snow", 1, 1);
    Harness window{command()};
    Program program{{{GL_COMPUTE_SHADER, "tests/step05_collision/collide_ways.comp"}}};
};

TEST_F(Walk, AcrossFacesInTheOpenChangesNothing)
{
    for (const float reach : {0.0f, 0.5f, 4.0f}) {
        const std::vector<Way> ways = ways_across_faces(reach);
        ASSERT_GT(ways.size(), 4000u);
        for (const auto& flakes : {walk_in_cpp(ways), walk_in_glsl(ways)}) {
            for (size_t i = 0; i < ways.size(); ++i) {
                ASSERT_EQ(flakes[i].position, ways[i].flake.position) << i;
                ASSERT_EQ(flakes[i].velocity, ways[i].flake.velocity) << i;
                ASSERT_EQ(flakes[i].rest, ways[i].flake.rest) << i;
            }
        }
    }
}

// Where a third of the cells are solid, so that there are corners everywhere.
TEST_F(Walk, AcrossFacesEndsOnTheWayOutsideWhatIsSolidAndRestsOnSomething)
{
    for (uint32_t& word : grid.words) {
        for (int x = 0; x < 32; ++x) word |= uint32_t(random(0, 1) < 0.33f) << x;
    }
    const auto solid_at = [&](vec3 point) {
        return grid.solid(ivec3(floor((point - grid.origin) / grid.cell_size)));
    };
    int slid = 0, landed = 0;
    for (const float reach : {0.0f, 0.5f, 4.0f}) {
        for (int repeat = 0; repeat < 10; ++repeat) {
            const std::vector<Way> ways = ways_across_faces(reach);
            for (const auto& flakes : {walk_in_cpp(ways), walk_in_glsl(ways)}) {
                for (size_t i = 0; i < ways.size(); ++i) {
                    const snow::Particle& flake = flakes[i];
                    const vec3 from = ways[i].from, to = ways[i].flake.position;
                    ASSERT_GE(flake.position.y, 0) << i;
                    ASSERT_FALSE(solid_at(flake.position)) << i;
                    const vec3 hair(0.0011f * grid.cell_size);  // kept from faces, and rounding
                    ASSERT_TRUE(all(greaterThan(flake.position, min(from, to) - hair)) &&
                                all(lessThan(flake.position, max(from, to) + hair)))
                        << i;
                    if (flake.rest > 0) {
                        ASSERT_TRUE(flake.position.y == 0 ||
                                    solid_at(flake.position - vec3(0, grid.cell_size, 0)))
                            << i << " rests in the air, at " << flake.position.y;
                    }
                    landed += flake.rest > 0;
                    slid += flake.rest == 0 && flake.position != to;
                }
            }
        }
    }
    EXPECT_GT(landed, 1000);
    EXPECT_GT(slid, 1000);
}

}  // namespace
