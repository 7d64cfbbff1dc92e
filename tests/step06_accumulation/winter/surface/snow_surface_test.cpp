// The surface that snow lifts: how fine it is, how far it is displaced, and that the field joins
// it.
#include "step06_accumulation/winter/surface/snow_surface.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <set>
#include <utility>

#include "step05_collision/ground.hpp"

using glm::vec3;

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
