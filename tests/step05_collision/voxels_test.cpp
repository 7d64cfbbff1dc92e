// The voxel grid of a scene and the walk of a flake through it.
#include <gtest/gtest.h>

#include <random>

#include "common/files.hpp"
#include "common/weather.hpp"
#include "step05_collision/triangle_box.hpp"
#include "step05_collision/voxel_grid.hpp"

using glm::ivec3;
using glm::vec3;

namespace snow {

// The one that is walked through.
VoxelGrid grid;

bool solid(ivec3 cell)
{
    return grid.solid(cell);
}

#include "step05_collision/voxel_walk.glsl"

}  // namespace snow

namespace {

std::mt19937 generator(1);

float random(float least, float most)
{
    return std::uniform_real_distribution<float>(least, most)(generator);
}

vec3 random_point(float reach)
{
    return {random(-reach, reach), random(-reach, reach), random(-reach, reach)};
}

void add_triangle(Scene& scene, vec3 a, vec3 b, vec3 c)
{
    for (const vec3 corner : {a, b, c}) {
        Vertex vertex{};
        vertex.position = corner;
        scene.indices.push_back(uint32_t(scene.vertices.size()));
        scene.vertices.push_back(vertex);
    }
}

Scene triangle_soup(int triangles, float size)  // m
{
    Scene scene;
    for (int i = 0; i < triangles; ++i) {
        const vec3 centre = random_point(5) + vec3(0, 5, 0);
        add_triangle(scene, centre + random_point(size), centre + random_point(size),
                     centre + random_point(size));
    }
    return scene;
}

// Is a part of the triangle inside the box? By cutting away what is outside, side by side
// (Sutherland and Hodgman 1974), in double precision: slow, and nothing like the separating axes.
bool part_remains_in_box(vec3 a, vec3 b, vec3 c, vec3 centre, vec3 half_size)
{
    std::vector<glm::dvec3> polygon = {glm::dvec3(a), glm::dvec3(b), glm::dvec3(c)};
    for (int axis = 0; axis < 3; ++axis) {
        for (const double side : {-1.0, 1.0}) {
            const auto inside = [&](glm::dvec3 p) {  // m, how far
                return double(half_size[axis]) - side * (p[axis] - double(centre[axis]));
            };
            std::vector<glm::dvec3> cut;
            for (size_t i = 0; i < polygon.size(); ++i) {
                const glm::dvec3 p = polygon[i], q = polygon[(i + 1) % polygon.size()];
                const double at_p = inside(p), at_q = inside(q);
                if (at_p >= 0) cut.push_back(p);
                if ((at_p >= 0) != (at_q >= 0)) cut.push_back(p + (q - p) * (at_p / (at_p - at_q)));
            }
            polygon = cut;
        }
    }
    return !polygon.empty();
}

// Every voxel against every triangle (but for those whose bounds are apart, to save minutes).
template <typename Test>
std::vector<bool> brute_force(const Scene& scene, const VoxelGrid& grid, float half, Test touches)
{
    const int n = grid.resolution;
    std::vector<bool> filled(size_t(n) * size_t(n) * size_t(n));
    for (size_t i = 0; i < scene.indices.size(); i += 3) {
        const vec3 a = scene.corner(i).position, b = scene.corner(i + 1).position,
                   c = scene.corner(i + 2).position;
        const vec3 least = (min(a, min(b, c)) - grid.origin) / grid.cell_size;
        const vec3 most = (max(a, max(b, c)) - grid.origin) / grid.cell_size;
        const ivec3 first = max(ivec3(floor(least)) - 1, 0),
                    last = min(ivec3(floor(most)) + 1, n - 1);
        for (int z = first.z; z <= last.z; ++z) {
            for (int y = first.y; y <= last.y; ++y) {
                for (int x = first.x; x <= last.x; ++x) {
                    const vec3 half_cell(0.5f * grid.cell_size);
                    const vec3 centre = grid.origin + grid.cell_size * vec3(x, y, z) + half_cell;
                    if (touches(a, b, c, centre, vec3(half)))
                        filled[size_t((z * n + y) * n + x)] = true;
                }
            }
        }
    }
    return filled;
}

void expect_grid_is_right(const Scene& scene, int resolution)
{
    const VoxelGrid grid = voxelise(scene, resolution);
    EXPECT_EQ(4 * grid.words.size(),
              size_t(resolution) * size_t(resolution) * size_t(resolution) / 8);

    const float half = 0.5f * grid.cell_size;
    const std::vector<bool> same_test = brute_force(scene, grid, half, snow::triangle_touches_box);
    // Where a triangle only grazes a voxel, rounding decides: the two tests need not agree. So the
    // second one asks for voxels a hair smaller and a hair larger; 1e-5 is ten times what rounding
    // moves a point 10 m from the origin.
    const float hair = 1e-5f;
    const std::vector<bool> certain = brute_force(scene, grid, half - hair, part_remains_in_box);
    const std::vector<bool> possible = brute_force(scene, grid, half + hair, part_remains_in_box);

    size_t filled = 0, wrong = 0, missing = 0, spurious = 0, i = 0;
    for (int z = 0; z < resolution; ++z) {
        for (int y = 0; y < resolution; ++y) {
            for (int x = 0; x < resolution; ++x, ++i) {
                const bool solid = grid.solid({x, y, z});
                filled += solid;
                wrong += solid != same_test[i];
                missing += certain[i] && !solid;
                spurious += solid && !possible[i];
            }
        }
    }
    EXPECT_GT(filled, 0u);
    EXPECT_EQ(wrong, 0u) << "voxels other than the same test gives without an octree";
    EXPECT_EQ(missing, 0u) << "voxels that a triangle enters";
    EXPECT_EQ(spurious, 0u) << "voxels that no triangle enters";
}

// A grid with nothing in it, 32 m wide, that stands on the ground.
VoxelGrid empty_grid(int resolution)
{
    VoxelGrid grid{};
    grid.resolution = resolution;
    grid.cell_size = 32.0f / float(resolution);
    grid.origin = vec3(-16, 0, -16);
    grid.words.resize(size_t(resolution) * size_t(resolution) * size_t(resolution) / 32);
    return grid;
}

void fill(VoxelGrid& grid, ivec3 cell)
{
    const int row = (cell.z * grid.resolution + cell.y) * grid.resolution / 32;
    grid.words[size_t(row + cell.x / 32)] |= 1u << (cell.x % 32);
}

const snow::Weather weather = snow::make_weather("snow", 1, 1);

snow::Particle flake_at(vec3 position, vec3 velocity)
{
    return {position, 1.0f, velocity, 0.0f};
}

// Moves the flake by a step and lets it collide.
snow::Particle walk(snow::Particle flake)
{
    const vec3 from = flake.position;
    flake.position += weather.time_step * flake.velocity;
    return snow::collide(from, flake, weather);
}

}  // namespace

TEST(VoxelGrid, OfTheCourtyardEqualsBruteForce)
{
    expect_grid_is_right(load_scene(find_file("common/assets/courtyard.obj"), 'y'), 64);
}

TEST(VoxelGrid, OfTriangleSoupsEqualsBruteForce)
{
    expect_grid_is_right(triangle_soup(1, 5), 64);
    expect_grid_is_right(triangle_soup(10, 4), 64);
    expect_grid_is_right(triangle_soup(100, 2), 64);
    expect_grid_is_right(triangle_soup(1000, 0.3f), 64);
    expect_grid_is_right(triangle_soup(100, 0.01f), 64);  // smaller than a voxel
    expect_grid_is_right(triangle_soup(50, 2), 32);
}

TEST(VoxelGrid, HoldsTrianglesWithoutArea)
{
    Scene scene = triangle_soup(1, 5);
    add_triangle(scene, vec3(0), vec3(4, 4, 4), vec3(2, 2, 2));              // a line
    add_triangle(scene, vec3(-4, 4, -4), vec3(-4, 4, -4), vec3(-4, 4, -4));  // a point
    const VoxelGrid grid = voxelise(scene, 64);
    for (const vec3 point : {vec3(0.1f), vec3(2.1f), vec3(3.9f), vec3(-4, 4, -4)}) {
        EXPECT_TRUE(grid.solid(ivec3(floor((point - grid.origin) / grid.cell_size)))) << point.x;
    }
}

TEST(VoxelGrid, IsEmptyOutsideAndForTheEmptyScene)
{
    const VoxelGrid grid = voxelise(Scene{}, 32);
    for (const uint32_t word : grid.words) EXPECT_EQ(word, 0u);
    for (const int outside : {-1, 32, 1000000}) {
        EXPECT_FALSE(grid.solid({outside, 0, 0}));
        EXPECT_FALSE(grid.solid({0, outside, 0}));
        EXPECT_FALSE(grid.solid({0, 0, outside}));
    }
}

TEST(VoxelWalk, FromAboveLandsInTheEmptyCellItCameFrom)
{
    VoxelGrid grid = empty_grid(32);  // cells of 1 m
    fill(grid, {16, 10, 16});         // its upper side is y = 11
    snow::grid = grid;
    for (const float speed : {0.5f, 10.0f, 200.0f}) {
        snow::Particle flake = flake_at({0.3f, 11.005f, 0.6f}, {0, -speed, 0});
        flake = walk(flake);
        EXPECT_EQ(snow::cell_of(flake.position), ivec3(16, 11, 16)) << speed;
        EXPECT_EQ(flake.velocity, vec3(0)) << speed;
        EXPECT_EQ(flake.rest, weather.time_step) << speed;
    }
}

TEST(VoxelWalk, FromTheSideLosesThatComponentAndSlidesOn)
{
    VoxelGrid grid = empty_grid(32);
    for (int y = 0; y < 32; ++y) fill(grid, {20, y, 16});  // its left side is x = 4
    snow::grid = grid;
    const snow::Particle flake = walk(flake_at({3.9f, 0.5f, 0.5f}, {60, -6, 0}));
    EXPECT_EQ(flake.velocity, vec3(0, -6, 0));
    EXPECT_EQ(flake.rest, 0);
    EXPECT_EQ(snow::cell_of(flake.position).x, 19);
    EXPECT_NEAR(flake.position.y, 0.4f, 1e-5) << "the rest of its way";
}

TEST(VoxelWalk, InTheOpenChangesNothing)
{
    const VoxelGrid grid = empty_grid(32);
    snow::grid = grid;
    for (int n = 0; n < 1000; ++n) {
        const snow::Particle flake = flake_at(random_point(30), random_point(200));
        const snow::Particle after = walk(flake);
        EXPECT_EQ(after.position, flake.position + weather.time_step * flake.velocity);
        EXPECT_EQ(after.velocity, flake.velocity);
        EXPECT_EQ(after.rest, 0);
    }
}

// A closed room with walls of one voxel. Flakes at up to 200 m/s and more, 3.3 m and seven voxels a
// step, must never be in a wall or outside, whatever they hit.
TEST(VoxelWalk, LetsNoFlakeThroughAWallAtAnySpeed)
{
    VoxelGrid grid = empty_grid(64);
    for (int a = 20; a <= 43; ++a) {
        for (int b = 20; b <= 43; ++b) {
            for (const int side : {20, 43}) {
                fill(grid, {side, a, b});
                fill(grid, {a, side, b});
                fill(grid, {a, b, side});
            }
        }
    }
    snow::grid = grid;
    for (int n = 0; n < 2000; ++n) {
        snow::Particle flake = flake_at(random_point(5.4f) + vec3(0, 16, 0), vec3(0));
        for (int step = 0; step < 60; ++step) {
            flake.rest = 0;
            flake.velocity = random_point(200);
            flake = walk(flake);
            const ivec3 cell = snow::cell_of(flake.position);
            ASSERT_TRUE(all(greaterThan(cell, ivec3(20))) && all(lessThan(cell, ivec3(43))))
                << "at " << flake.position.x << " " << flake.position.y << " " << flake.position.z;
        }
    }
}

TEST(VoxelWalk, NeverEndsInASolidVoxel)
{
    const Scene scene = triangle_soup(300, 1);
    const VoxelGrid grid = voxelise(scene, 64);
    snow::grid = grid;
    int hits = 0;
    for (int n = 0; n < 100000; ++n) {
        const vec3 start = random_point(6) + vec3(0, 6, 0);
        if (grid.solid(snow::cell_of(start))) continue;
        const float speed = random(0, 1) < 0.5f ? 200.0f : 5.0f;  // m/s
        const snow::Particle flake = walk(flake_at(start, random_point(speed)));
        ASSERT_FALSE(grid.solid(snow::cell_of(flake.position)));
        hits += flake.rest > 0;
    }
    EXPECT_GT(hits, 1000);
}

// A grid begins at the ground, on which flakes land in any case, and reaches what stands high above
// it.
TEST(VoxelGrid, HoldsWhatHasNothingBelowIt)
{
    Scene roof;
    add_triangle(roof, {-1, 5, -1}, {-1, 5, 1}, {1, 5, 1});
    const VoxelGrid grid = voxelise(roof, 64);
    EXPECT_LT(grid.origin.y, 0);
    EXPECT_TRUE(grid.solid(ivec3(floor((vec3(-0.5f, 5, 0) - grid.origin) / grid.cell_size))));
}

// Or a flake would walk through thousands of them in a step.
TEST(VoxelGrid, OfSomethingTinyIsOfVoxelsAsLargeAsThatOfAMetre)
{
    Scene speck;
    add_triangle(speck, {0, 0, 0}, {0, 0, 0.01f}, {0.01f, 0, 0});
    EXPECT_FLOAT_EQ(place_grid(speck, 256).cell_size, 1.0f / 254);
}
