// The surface of the snow: how fine it is, how steep parts rise, how the field joins the ground.
#include "step06_accumulation/winter/surface/snow_surface.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <set>
#include <utility>

#include "step05_collision/ground.hpp"

using glm::vec3;

// Where cells are wider than a metre, pieces of a metre show nothing more, and take long to make.
TEST(SnowSurface, IsNoFinerThanItsCellsAskFor)
{
    Scene scene;
    for (const vec3 place : {vec3(-200, 0, -200), vec3(-200, 0, 200), vec3(200, 0, 200)})
        scene.vertices.push_back({place, {0, 1, 0}, {}, {}});
    scene.indices = {0, 1, 2};
    scene.submeshes.push_back({{}, 0, 3});
    const float fine_enough = 4.7f;
    const std::vector<SurfaceSubmesh> submeshes = make_snow_surface(scene, fine_enough);
    EXPECT_TRUE(submeshes[0].coarse.empty());
    // Halves of a square are halved until their longest edge is short enough: then it is at least
    // 1 / sqrt(2) of that, and the area a quarter of its square.
    const double smallest = fine_enough * fine_enough / 2 / 4;
    EXPECT_LE(double(submeshes[0].fine.size()) / 3, 0.5 * 400 * 400 / smallest);
}

// A gentle slope and a steep one below it. Along the edge that they share both go up with the snow
// alike, or one would see between them.
TEST(SnowSurface, IsDisplacedLessWhereItIsSteep)
{
    Scene scene;
    const vec3 steep_normal = glm::normalize(vec3(1, 0.2f, 0));
    const auto add = [&](vec3 place, vec3 normal) {
        scene.indices.push_back(uint32_t(scene.vertices.size()));
        scene.vertices.push_back({place, normal, {}, {}});
    };
    const vec3 above(-1, 2, 0), a(0, 2, 1), b(0, 2, -1), below(0.2f, 1, 0);
    for (const vec3 place : {above, a, b}) add(place, {0, 1, 0});
    for (const vec3 place : {b, a, below}) add(place, steep_normal);
    scene.submeshes.push_back({{}, 0, scene.indices.size()});
    int on_edge = 0, at_the_bottom = 0;
    const std::vector<SurfaceSubmesh> submeshes = make_snow_surface(scene, 4);
    for (const SurfaceVertex& corner : submeshes[0].fine) {
        const vec3 place = corner.vertex.position;
        if (place.x == 0) {
            EXPECT_EQ(corner.displacement, 1);
            on_edge += corner.vertex.normal == steep_normal;
        } else if (place == below) {
            EXPECT_NEAR(corner.displacement, glm::smoothstep(0.1f, 0.4f, steep_normal.y), 1e-5f);
            ++at_the_bottom;
        }
    }
    EXPECT_EQ(on_edge, 2);
    EXPECT_EQ(at_the_bottom, 1);
}

// Squares of half a metre in the courtyard's room; in a valley as wide as 400 m there would be as
// many as voxels.
TEST(Ground, IsMadeOfAtMost64SquaresAlongAnEdge)
{
    for (const float width : {16.0f, 400.0f}) {
        VoxelGrid grid{};
        grid.resolution = 256;
        grid.cell_size = width / 254;
        grid.words.resize(256 * 256 * 256 / 32);
        const int square = ground_square(grid);
        EXPECT_EQ(square, width == 16 ? 7 : 4);
        Scene scene;
        scene.vertices.push_back({});  // not the empty scene, but one without a floor
        const size_t along_edge = size_t((256 + square - 1) / square);
        EXPECT_EQ(with_ground(scene, grid).indices.size(), 6 * along_edge * along_edge);
    }
}

// Every corner of the ground along the edge of the grid is one of the field, too, and the other way
// round: or there would be gaps between them once snow lifts both.
TEST(Field, JoinsTheGroundCornerByCorner)
{
    VoxelGrid grid{};
    grid.resolution = 64;
    grid.cell_size = 0.29f;
    grid.origin = {-9, -0.29f, -9.5f};
    grid.words.resize(64 * 64 * 64 / 32);
    Scene scene;
    scene.vertices.push_back({});  // not the empty scene, but one without a floor
    scene = with_ground(scene, grid);
    const glm::vec2 low(grid.origin.x, grid.origin.z), high = low + 64 * grid.cell_size;
    const auto on_edge = [&](vec3 p) {
        const glm::vec2 place(p.x, p.z);
        const float margin = 1e-4f;
        return glm::all(glm::greaterThan(place, low - margin)) &&
               glm::all(glm::lessThan(place, high + margin)) &&
               (glm::any(glm::lessThan(place, low + margin)) ||
                glm::any(glm::greaterThan(place, high - margin)));
    };
    const auto rounded = [](vec3 p) {
        return std::pair(std::lround(1e3 * p.x), std::lround(1e3 * p.z));
    };
    std::set<std::pair<long, long>> ground, field;
    for (size_t i = 1; i < scene.vertices.size(); ++i) {
        if (on_edge(scene.vertices[i].position)) ground.insert(rounded(scene.vertices[i].position));
    }
    for (const SurfaceVertex& corner : make_field(grid, false).coarse) {
        if (on_edge(corner.vertex.position)) field.insert(rounded(corner.vertex.position));
    }
    EXPECT_EQ(ground, field);
    EXPECT_GT(ground.size(), 100u);
}

TEST(Field, FacesUp)
{
    VoxelGrid grid{};
    grid.resolution = 32;
    grid.cell_size = 0.5f;
    for (const bool with_middle : {false, true}) {
        const SurfaceSubmesh field = make_field(grid, with_middle);
        for (const auto* corners : {&field.coarse, &field.bare}) {
            for (size_t i = 0; i < corners->size(); i += 3) {
                const vec3 a = (*corners)[i].vertex.position, b = (*corners)[i + 1].vertex.position,
                           c = (*corners)[i + 2].vertex.position;
                ASSERT_GE(glm::cross(b - a, c - a).y, 0);
            }
        }
    }
}
