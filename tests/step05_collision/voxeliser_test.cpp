// The voxels that the GPU makes of a scene against those of the CPU, in a window of its own.
#include "step05_collision/voxelise_on_gpu.hpp"

#include <gtest/gtest.h>

#include <random>

#include "common/files.hpp"
#include "common/harness/harness.hpp"
#include "common/window.hpp"
#include "step05_collision/triangle_box.hpp"

using glm::ivec3;
using glm::vec3;

namespace {

CommandLine command()
{
    std::vector<std::string> words = {"voxeliser_test", "--size", "64x64"};
    std::vector<char*> argv;
    for (std::string& word : words) argv.push_back(word.data());
    return parse_command_line(int(argv.size()), argv.data(),
                              {.name = "voxeliser_test",
                               .idea = "a test",
                               .minimum_gl = 4.2,
                               .variants = {{"voxels", nullptr}}});
}

// Does any triangle touch the voxel if that is this much as large as it is?
bool is_touched(const Scene& scene, const VoxelGrid& grid, ivec3 cell, float scale)
{
    const vec3 half_size(0.5f * grid.cell_size);
    const vec3 centre = grid.origin + grid.cell_size * vec3(cell) + half_size;
    for (size_t i = 0; i < scene.indices.size(); i += 3) {
        if (snow::triangle_touches_box(scene.corner(i).position, scene.corner(i + 1).position,
                                       scene.corner(i + 2).position, centre, scale * half_size))
            return true;
    }
    return false;
}

// The share of the voxels filled that only one of the two fills, all of which are only touched.
double share_that_differs(const Scene& scene, int resolution)
{
    const VoxelGrid cpu = voxelise(scene, resolution), gpu = voxelise_on_gpu(scene, resolution);
    EXPECT_EQ(glGetError(), GLenum(GL_NO_ERROR));
    EXPECT_EQ(cpu.origin, gpu.origin);
    EXPECT_EQ(cpu.cell_size, gpu.cell_size);
    int filled = 0, different = 0;
    ivec3 cell;
    for (cell.z = 0; cell.z < resolution; ++cell.z) {
        for (cell.y = 0; cell.y < resolution; ++cell.y) {
            for (cell.x = 0; cell.x < resolution; ++cell.x) {
                filled += cpu.solid(cell);
                if (cpu.solid(cell) == gpu.solid(cell)) continue;
                ++different;
                EXPECT_TRUE(is_touched(scene, cpu, cell, 1.001f)) << "one that no triangle is near";
                EXPECT_FALSE(is_touched(scene, cpu, cell, 0.999f)) << "one that a triangle enters";
            }
        }
    }
    EXPECT_GT(filled, 0);
    return double(different) / filled;
}

Scene triangle_soup(unsigned seed, int triangles, float size)  // m
{
    std::mt19937 generator(seed);
    const auto point = [&](float reach) {
        std::uniform_real_distribution<float> number(-reach, reach);
        const float x = number(generator), y = number(generator), z = number(generator);
        return vec3(x, y, z);
    };
    Scene scene;
    for (int i = 0; i < triangles; ++i) {
        const vec3 centre = point(5) + vec3(0, 5, 0);
        for (int corner = 0; corner < 3; ++corner) {
            scene.indices.push_back(uint32_t(scene.vertices.size()));
            scene.vertices.push_back({centre + point(size), vec3(0), vec3(0), glm::vec2(0)});
        }
    }
    return scene;
}

}  // namespace

TEST(VoxeliserOnTheGpu, DiffersInVoxelsThatAreOnlyTouched)
{
    const Harness window{command()};
    const double rounding = 1e-3;  // of the voxels; what is drawn on their faces, as walls are, may
                                   // come to lie on either side
    EXPECT_LE(share_that_differs(load_scene(find_file("common/assets/courtyard.obj"), 'y'), 128),
              rounding);
    EXPECT_LE(share_that_differs(triangle_soup(1, 5, 4), 64), rounding);
    EXPECT_LE(share_that_differs(triangle_soup(2, 300, 1), 64), rounding);
    EXPECT_LE(share_that_differs(triangle_soup(3, 1000, 0.01f), 64),
              rounding);  // less than a voxel

    // Without area: a line and a point.
    Scene thin;
    for (const vec3 corner : {vec3(0), vec3(4, 4, 4), vec3(2, 2, 2), vec3(-4, 4, -4),
                              vec3(-4, 4, -4), vec3(-4, 4, -4)}) {
        thin.indices.push_back(uint32_t(thin.vertices.size()));
        thin.vertices.push_back({corner, vec3(0), vec3(0), glm::vec2(0)});
    }
    const VoxelGrid grid = voxelise_on_gpu(thin, 64);
    for (const vec3 point : {vec3(0.1f), vec3(2.1f), vec3(3.9f), vec3(-4, 4, -4)})
        EXPECT_TRUE(grid.solid(ivec3(floor((point - grid.origin) / grid.cell_size)))) << point.x;
    EXPECT_EQ(voxelise_on_gpu(Scene{}, 32).words, voxelise(Scene{}, 32).words);
}
