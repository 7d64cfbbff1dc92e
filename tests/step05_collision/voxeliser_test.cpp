// The voxels that the CPU and the GPU make of a scene, in a window of its own: against a test of
// every voxel with every triangle, and against each other.
#include <gtest/gtest.h>

#include <random>

#include "common/files.hpp"
#include "step05_collision/voxel_grid.hpp"
#include "step05_collision/voxelise_on_gpu.hpp"
#include "tests/common/harness/small_window.hpp"

using glm::dvec3;
using glm::ivec3;
using glm::vec3;

namespace {

void add_triangle(Scene& scene, vec3 a, vec3 b, vec3 c)
{
    for (const vec3 corner : {a, b, c}) {
        scene.indices.push_back(uint32_t(scene.vertices.size()));
        scene.vertices.push_back({corner, vec3(0), vec3(0), glm::vec2(0)});
    }
}

Scene triangle_soup(int triangles, float size)  // m
{
    static std::mt19937 generator(1);
    const auto point = [&](float reach) {
        std::uniform_real_distribution<float> number(-reach, reach);
        const float x = number(generator), y = number(generator), z = number(generator);
        return vec3(x, y, z);
    };
    Scene scene;
    for (int i = 0; i < triangles; ++i) {
        const vec3 centre = point(5) + vec3(0, 5, 0);
        add_triangle(scene, centre + point(size), centre + point(size), centre + point(size));
    }
    return scene;
}

// Is a part of the triangle inside the box? By cutting away what is outside, side by side
// (Sutherland and Hodgman 1974), in double precision: slow, and nothing like the separating axes.
bool part_remains_in_box(vec3 a, vec3 b, vec3 c, vec3 centre, float half_size)
{
    std::vector<dvec3> polygon = {dvec3(a), dvec3(b), dvec3(c)};
    for (int axis = 0; axis < 3; ++axis) {
        for (const double side : {-1.0, 1.0}) {
            const auto inside = [&](dvec3 p) {  // m, how far
                return double(half_size) - side * (p[axis] - double(centre[axis]));
            };
            std::vector<dvec3> cut;
            for (size_t i = 0; i < polygon.size(); ++i) {
                const dvec3 p = polygon[i], q = polygon[(i + 1) % polygon.size()];
                const double at_p = inside(p), at_q = inside(q);
                if (at_p >= 0) cut.push_back(p);
                if ((at_p >= 0) != (at_q >= 0)) cut.push_back(p + (q - p) * (at_p / (at_p - at_q)));
            }
            polygon = cut;
        }
    }
    return !polygon.empty();
}

// Every voxel against every triangle (but for those whose bounds are apart, to save minutes), if
// voxels are `scale` times as large as they are.
std::vector<bool> brute_force(const Scene& scene, const VoxelGrid& grid, float scale)
{
    const int n = grid.resolution;
    std::vector<bool> filled(size_t(n * n * n));
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
                    const vec3 centre = grid.origin + grid.cell_size * (vec3(x, y, z) + 0.5f);
                    if (part_remains_in_box(a, b, c, centre, 0.5f * scale * grid.cell_size))
                        filled[size_t((z * n + y) * n + x)] = true;
                }
            }
        }
    }
    return filled;
}

void expect_voxels_are_right(const Scene& scene, int resolution)
{
    const VoxelGrid cpu = voxelise(scene, resolution), gpu = voxelise_on_gpu(scene, resolution);
    EXPECT_EQ(glGetError(), GLenum(GL_NO_ERROR));
    EXPECT_EQ(cpu.origin, gpu.origin);
    EXPECT_EQ(cpu.cell_size, gpu.cell_size);
    EXPECT_EQ(32 * cpu.words.size(), size_t(resolution * resolution * resolution));
    // Where a triangle only grazes a voxel rounding decides, and tests need not agree.
    const std::vector<bool> certain = brute_force(scene, cpu, 0.999f),
                            possible = brute_force(scene, cpu, 1.001f);
    int filled = 0, different = 0;
    for (int i = 0; i < resolution * resolution * resolution; ++i) {
        const ivec3 cell(i % resolution, i / resolution % resolution, i / resolution / resolution);
        filled += cpu.solid(cell);
        different += cpu.solid(cell) != gpu.solid(cell);
        for (const VoxelGrid* grid : {&cpu, &gpu}) {
            ASSERT_TRUE(grid->solid(cell) || !certain[size_t(i)]) << "a triangle enters " << i;
            ASSERT_TRUE(!grid->solid(cell) || possible[size_t(i)]) << "no triangle is near " << i;
        }
    }
    EXPECT_GT(filled, 0);
    // What is drawn on their faces, as walls are, may come to lie on either side.
    EXPECT_LE(different, 1e-3 * filled);
}

bool solid_at(const VoxelGrid& grid, vec3 point)
{
    return grid.solid(ivec3(floor((point - grid.origin) / grid.cell_size)));
}

}  // namespace

TEST(Voxels, AreThoseThatTrianglesTouch)
{
    const Harness window{small_window(4.2)};
    expect_voxels_are_right(load_scene(find_file("common/assets/courtyard.obj"), 'y'), 128);
    expect_voxels_are_right(triangle_soup(1, 5), 64);
    expect_voxels_are_right(triangle_soup(100, 2), 64);
    expect_voxels_are_right(triangle_soup(1000, 0.01f), 64);  // smaller than a voxel
    expect_voxels_are_right(triangle_soup(50, 2), 32);

    Scene thin;
    add_triangle(thin, vec3(0), vec3(4, 4, 4), vec3(2, 2, 2));              // a line
    add_triangle(thin, vec3(-4, 4, -4), vec3(-4, 4, -4), vec3(-4, 4, -4));  // a point
    for (const VoxelGrid& grid : {voxelise(thin, 64), voxelise_on_gpu(thin, 64)}) {
        for (const vec3 point : {vec3(0.1f), vec3(2.1f), vec3(3.9f), vec3(-4, 4, -4)})
            EXPECT_TRUE(solid_at(grid, point)) << point.x;
    }
    const VoxelGrid empty = voxelise(Scene{}, 32);
    EXPECT_EQ(empty.words, std::vector<uint32_t>(32 * 32));
    EXPECT_EQ(empty.words, voxelise_on_gpu(Scene{}, 32).words);
}

// A grid begins at the ground, on which flakes land in any case, and reaches what stands high above
// it; outside of it nothing is solid.
TEST(Voxels, HoldWhatHasNothingBelowIt)
{
    Scene roof;
    add_triangle(roof, {-1, 5, -1}, {-1, 5, 1}, {1, 5, 1});
    const VoxelGrid grid = voxelise(roof, 64);
    EXPECT_LT(grid.origin.y, 0);
    EXPECT_TRUE(solid_at(grid, vec3(-0.5f, 5, 0)));
    for (const int outside : {-1, 64, 1000000}) {
        for (const ivec3 axis : {ivec3(1, 0, 0), ivec3(0, 1, 0), ivec3(0, 0, 1)})
            EXPECT_FALSE(grid.solid(outside * axis));
    }
}

// Or a flake would walk through thousands of them in a step.
TEST(Voxels, OfSomethingTinyAreAsLargeAsThoseOfAMetre)
{
    Scene speck;
    add_triangle(speck, {0, 0, 0}, {0, 0, 0.01f}, {0.01f, 0, 0});
    EXPECT_FLOAT_EQ(place_grid(speck, 256).cell_size, 1.0f / 254);
}
