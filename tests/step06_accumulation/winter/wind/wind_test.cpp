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

VoxelGrid mirrored(const VoxelGrid& grid)  // left and right
{
    VoxelGrid other = empty_grid();
    for (int i = 0; i < n * n * n; ++i) {
        const ivec3 cell(i % n, i / n % n, i / n / n);
        const ivec3 opposite(n - 1 - cell.x, cell.y, cell.z);
        if (grid.solid(2 * cell)) fill(other, opposite, opposite);
    }
    return other;
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
            const size_t low = AirFlow::face(cell), high = AirFlow::face(next);
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
}

TEST(Wind, IsEvenWhereNothingStands)
{
    const AirFlow flow = flow_around(empty_grid(), {0, 0, -1});
    for (int i = 0; i < n; ++i) {
        const vec3 air = flow.at_cell({i, n - 1 - i, i / 2});
        EXPECT_NEAR(glm::distance(air, vec3(0, 0, -1)), 0, 1e-4) << i;
    }
}

TEST(Wind, DoesNotFlowThroughWhatIsSolid)
{
    VoxelGrid grid = empty_grid();
    const ivec3 first(10, 0, 8), last(14, 7, 20);
    fill(grid, first, last);
    const AirFlow flow = flow_around(grid, {1, 0, 0});
    for (int y = 0; y <= last.y; ++y) {
        for (int z = first.z; z <= last.z; ++z) {
            for (int x = first.x; x <= last.x + 1; ++x) {
                EXPECT_EQ(flow.open[0][AirFlow::face({x, y, z})], 0) << x << " " << y << " " << z;
            }
            EXPECT_EQ(flow.at_cell({12, y, z}), vec3(0));
        }
    }
    for (int i = 0; i < n * n; ++i) {
        EXPECT_EQ(flow.open[1][AirFlow::face({i % n, 0, i / n})], 0) << "the ground";
    }
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

// The wake of something small ends sooner.
TEST(Wind, RecoversBehindAPost)
{
    VoxelGrid grid = empty_grid();
    fill(grid, {8, 0, 16}, {8, 3, 16});
    const AirFlow flow = flow_around(grid, {1, 0, 0});
    EXPECT_LT(flow.at_cell({9, 2, 16}).x, 0.5f);
    EXPECT_GT(flow.at_cell({13, 2, 16}).x, 0.6f);
    EXPECT_GT(flow.at_cell({24, 2, 16}).x, 0.8f);
}

TEST(Wind, OfTheMirroredSceneIsMirrored)
{
    VoxelGrid grid = empty_grid();
    fill(grid, {6, 0, 10}, {9, 6, 14});
    fill(grid, {20, 3, 4}, {26, 4, 18});
    const AirFlow flow = flow_around(grid, {1, 0, 0});
    const AirFlow other = flow_around(mirrored(grid), {-1, 0, 0});
    for (int i = 0; i < n * n * n; ++i) {
        const ivec3 cell(i % n, i / n % n, i / n / n);
        const vec3 air = flow.at_cell(cell),
                   opposite = other.at_cell({n - 1 - cell.x, cell.y, cell.z});
        ASSERT_NEAR(glm::distance(air, vec3(-1, 1, 1) * opposite), 0, 1e-3)
            << cell.x << " " << cell.y << " " << cell.z;
    }
}
