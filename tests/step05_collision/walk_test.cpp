// The walk of a flake through the voxels, in both its languages: as C++, and in a window of its own
// as GLSL.
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <random>

#include "common/uniform_block.hpp"
#include "common/weather.hpp"
#include "step05_collision/solid_scene.hpp"
#include "tests/common/harness/small_window.hpp"

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

    void fill(ivec3 cell) { grid.words[size_t(cell.z * 32 + cell.y)] |= 1u << cell.x; }

    vec3 place(vec3 cells) const { return grid.origin + grid.cell_size * cells; }

    ivec3 cell_of(vec3 place) const { return floor((place - grid.origin) / grid.cell_size); }

    float random(float least, float most)
    {
        return std::uniform_real_distribution<float>(least, most)(generator);
    }

    vec3 random_point(float least, float most)
    {
        const float x = random(least, most), y = random(least, most), z = random(least, most);
        return {x, y, z};
    }

    Way way(vec3 from, vec3 velocity) const
    {
        return {from, 0, {from + weather.time_step * velocity, 1, velocity, 0}};
    }

    // Across every face between two cells, from either side, or up to it: from -3 to 3 ulps off the
    // face to -3 to 3 ulps off, and along the other axes as far as `reach` cells.
    std::vector<Way> ways_across_faces(float reach)
    {
        std::vector<Way> ways;
        for (int n = 0; n < 3 * 33 * 7 * 7; ++n) {
            const int axis = n % 3, face = n / 3 % 33, begin = n / 99 % 7 - 3, end = n / 693 - 3;
            if (axis == 1 && face == 0) continue;
            vec3 from = place({random(0, 32), random(1, 32), random(0, 32)});
            vec3 to = from + grid.cell_size * random_point(-reach, reach);
            from[axis] = ulps_from(place(vec3(face))[axis], begin);
            to[axis] = ulps_from(place(vec3(face))[axis], end);
            if (grid.solid(cell_of(from))) continue;
            const vec3 velocity = (to - from) / weather.time_step;
            // Like an update, which lets a flake settle on the ground first.
            ways.push_back({from, 0, snow::settle({to, 1.0f, velocity, 0.0f}, weather)});
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

    std::vector<snow::Particle> walk_in_glsl(const std::vector<Way>& ways)
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
        std::vector<Way> walked(ways.size());
        glGetBufferSubData(GL_SHADER_STORAGE_BUFFER, 0, bytes, walked.data());
        std::vector<snow::Particle> flakes;
        for (const Way& way : walked) flakes.push_back(way.flake);
        return flakes;
    }

    std::mt19937 generator{1};
    VoxelGrid grid{};
    const snow::Weather weather = snow::make_weather("snow", 1, 1);
    Harness window{small_window(4.3)};
    Program program{{{GL_COMPUTE_SHADER, "tests/step05_collision/collide_ways.comp"}}};
};

TEST_F(Walk, LandsAboveWhatIsSolidAndSlidesAlongItsSide)
{
    fill({16, 10, 16});
    fill({20, 5, 16});
    std::vector<Way> ways = {way(place({19.9f, 5.5f, 16.5f}), {60, -6, 0})};
    for (const float speed : {0.5f, 10.0f, 200.0f})
        ways.push_back(way(place({16.3f, 11.005f, 16.6f}), {0, -speed, 0}));
    for (const auto& flakes : {walk_in_cpp(ways), walk_in_glsl(ways)}) {
        EXPECT_EQ(cell_of(flakes[0].position).x, 19);
        EXPECT_NEAR(flakes[0].position.y, ways[0].flake.position.y, 1e-5) << "the rest of its way";
        EXPECT_EQ(flakes[0].velocity, vec3(0, -6, 0));
        EXPECT_EQ(flakes[0].rest, 0);
        for (size_t i = 1; i < flakes.size(); ++i) {
            EXPECT_EQ(cell_of(flakes[i].position), ivec3(16, 11, 16)) << i;
            EXPECT_EQ(flakes[i].velocity, vec3(0)) << i;
            EXPECT_EQ(flakes[i].rest, weather.time_step) << i;
        }
    }
}

// A closed room with walls of one voxel. Flakes at 200 m/s and more, six voxels a step, must never
// be in a wall or outside, whatever they hit.
TEST_F(Walk, LeadsThroughNoWallAtAnySpeed)
{
    for (int a = 8; a <= 23; ++a) {
        for (int b = 8; b <= 23; ++b) {
            for (const int side : {8, 23}) {
                for (const ivec3 cell : {ivec3(side, a, b), ivec3(a, side, b), ivec3(a, b, side)})
                    fill(cell);
            }
        }
    }
    std::vector<Way> ways(2000);
    for (const bool in_glsl : {false, true}) {
        for (Way& way : ways) way.flake.position = place(random_point(9.01f, 22.99f));
        for (int step = 0; step < 60; ++step) {
            for (Way& each : ways) each = way(each.flake.position, random_point(-200, 200));
            const auto flakes = in_glsl ? walk_in_glsl(ways) : walk_in_cpp(ways);
            for (size_t i = 0; i < ways.size(); ++i) {
                const ivec3 cell = cell_of(flakes[i].position);
                ASSERT_TRUE(all(greaterThan(cell, ivec3(8))) && all(lessThan(cell, ivec3(23))))
                    << "cell " << cell.x << " " << cell.y << " " << cell.z;
                ways[i].flake = flakes[i];
            }
        }
    }
}

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
    int slid = 0, landed = 0;
    for (int repeat = 0; repeat < 30; ++repeat) {
        const std::vector<Way> ways = ways_across_faces(std::array{0.0f, 0.5f, 4.0f}[repeat % 3]);
        for (const auto& flakes : {walk_in_cpp(ways), walk_in_glsl(ways)}) {
            for (size_t i = 0; i < ways.size(); ++i) {
                const snow::Particle& flake = flakes[i];
                const vec3 from = ways[i].from, to = ways[i].flake.position;
                ASSERT_GE(flake.position.y, 0) << i;
                ASSERT_FALSE(grid.solid(cell_of(flake.position))) << i;
                const vec3 hair(0.0011f * grid.cell_size);  // kept from faces, and rounding
                ASSERT_TRUE(all(greaterThan(flake.position, min(from, to) - hair)) &&
                            all(lessThan(flake.position, max(from, to) + hair)))
                    << i;
                ASSERT_TRUE(flake.rest == 0 || flake.position.y == 0 ||
                            grid.solid(cell_of(flake.position - vec3(0, grid.cell_size, 0))))
                    << i << " rests in the air, at " << flake.position.y;
                landed += flake.rest > 0;
                slid += flake.rest == 0 && flake.position != to;
            }
        }
    }
    EXPECT_GT(landed, 1000);
    EXPECT_GT(slid, 1000);
}

}  // namespace
