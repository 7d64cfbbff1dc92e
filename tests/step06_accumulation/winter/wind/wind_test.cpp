// The wind around small scenes of voxels.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "common/files.hpp"
#include "step06_accumulation/winter/wind/wind_field.hpp"

using glm::ivec3;
using glm::vec3;

namespace {

constexpr int n = AirFlow::cells;

// A grid of two voxels a cell of the field, with nothing in it.
VoxelGrid empty_grid()
{
    VoxelGrid grid{};
    grid.resolution = 2 * n;
    grid.cell_size = 0.25f;
    grid.words.resize(size_t(grid.resolution * grid.resolution * grid.resolution / 32));
    return grid;
}

// Fills a block of the field's cells, `last` included.
void fill(VoxelGrid& grid, ivec3 first, ivec3 last)
{
    for (int z = 2 * first.z; z < 2 * last.z + 2; ++z) {
        for (int y = 2 * first.y; y < 2 * last.y + 2; ++y) {
            for (int x = 2 * first.x; x < 2 * last.x + 2; ++x) {
                grid.words[size_t((z * grid.resolution + y) * grid.resolution + x) / 32] |=
                    1u << (x % 32);
            }
        }
    }
}

float largest_divergence(const AirFlow& flow)
{
    float largest = 0;
    for (int i = 0; i < n * n * n; ++i) {
        const ivec3 cell(i % n, i / n % n, i / n / n);
        float sum = 0;
        for (int axis = 0; axis < 3; ++axis) {
            ivec3 next = cell;
            ++next[axis];
            const size_t low = AirFlow::face(cell);
            const size_t high = AirFlow::face(next);
            sum += flow.open[axis][high] * flow.speed[axis][high] -
                   flow.open[axis][low] * flow.speed[axis][low];
        }
        largest = std::max(largest, std::abs(sum));
    }
    return largest;
}

}  // namespace

// What flows into a cell flows out of it, for wind from all sides.
TEST(Wind, IsFreeOfDivergence)
{
    VoxelGrid box = empty_grid();
    fill(box, {12, 0, 12}, {19, 9, 17});
    fill(box, {4, 4, 4}, {8, 4, 25});  // a roof
    const Scene courtyard = load_scene(find_file("common/assets/courtyard.obj"), 'y');
    for (const VoxelGrid& grid : {empty_grid(), box, voxelise(courtyard, 128)}) {
        for (const vec3 wind : {vec3(1, 0, 0), vec3(-1, 0, 0), vec3(0, 0, 1), vec3(0, 0, -1)}) {
            const AirFlow flow = flow_around(grid, wind);
            EXPECT_LT(largest_divergence(flow), 1e-3);
            EXPECT_LT(flow.residual, 1e-3);
        }
    }
    const vec3 even = flow_around(empty_grid(), {0, 0, -1}).at_cell({9, 3, 20});
    EXPECT_NEAR(glm::distance(even, vec3(0, 0, -1)), 0, 1e-4);
}

// Into what is solid, or into the ground.
TEST(Wind, DoesNotFlowThroughWhatIsSolid)
{
    VoxelGrid grid = empty_grid();
    const ivec3 first(10, 0, 8), last(14, 7, 20);
    fill(grid, first, last);
    const AirFlow flow = flow_around(grid, {1, 0, 0});
    for (int i = 0; i < n * n * n; ++i) {
        const ivec3 cell(i % n, i / n % n, i / n / n);
        const bool inside = glm::all(glm::greaterThanEqual(cell, first)) &&
                            glm::all(glm::lessThanEqual(cell, last));
        const size_t face = AirFlow::face(cell);
        EXPECT_TRUE(flow.open[0][face] == 0 || !inside) << cell.x << " " << cell.y << " " << cell.z;
        EXPECT_TRUE(flow.open[1][face] == 0 || !(inside || cell.y == 0)) << cell.x << " " << cell.z;
    }
    EXPECT_EQ(flow.at_cell({12, 4, 14}), vec3(0));
}

// A wall 2 cells thick and 6 high across the wind.
TEST(Wind, IsFastOverAWallAndSlowBehindIt)
{
    VoxelGrid grid = empty_grid();
    fill(grid, {15, 0, 8}, {16, 5, 23});
    const AirFlow flow = flow_around(grid, {1, 0, 0});
    const float upwind = flow.at_cell({1, 2, 16}).x, far_above = flow.at_cell({16, 26, 16}).x;
    const float before = flow.at_cell({13, 2, 16}).x, over = flow.at_cell({16, 6, 16}).x;
    EXPECT_GT(upwind, 0.8f);
    EXPECT_NEAR(far_above, 1, 0.05f);
    EXPECT_GT(over, 1.1f);
    EXPECT_LT(before, 0.5f * upwind);
    for (int x = 18; x < 28; ++x) {  // as far as the wall is high, and nearly twice
        const float lee = flow.at_cell({x, 2, 16}).x;
        EXPECT_LT(lee, 0.25f * upwind) << x;
        EXPECT_GT(lee, -0.1f) << x;
    }
    EXPECT_GT(flow.at_cell({13, 2, 26}).x, 1.0f) << "beside it";
    EXPECT_GT(flow.at_cell({14, 5, 16}).y, 0.2f) << "up before it";
    EXPECT_LT(flow.at_cell({18, 5, 16}).y, 0.05f);
}
