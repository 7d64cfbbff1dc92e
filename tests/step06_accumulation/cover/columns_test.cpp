// Snow that lies, in a window of its own: what slides comes to rest at the angle of repose, and no
// unit of mass is lost.
#include "step06_accumulation/cover/columns.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <fstream>
#include <glm/gtc/constants.hpp>
#include <numeric>

#include "common/uniform_block.hpp"
#include "step06_accumulation/cover/snow_cover.hpp"
#include "tests/common/harness/small_window.hpp"

namespace {

using glm::ivec3;

constexpr GLuint full = 65536;

const std::string floor_obj = "v -8 0 -8\nv -8 0 8\nv 8 0 8\nv 8 0 -8\nf 1 2 3 4\n"
                              // a table of 4 m, 2 m high, off the middle
                              "v 2 2 2\nv 2 2 6\nv 6 2 6\nv 6 2 2\nf 5 6 7 8\n";

// The window, and a scene of 64^3 voxels in it, on which no flake falls.
class SnowThatLies : public testing::Test {
protected:
    static CommandLine command()
    {
        CommandLine command = small_window(4.3);
        command.lesson.has_scene = true;
        command.scene = testing::TempDir() + "/snowfall_floor.obj";
        command.voxels = 64;
        std::ofstream(command.scene) << floor_obj;
        return command;
    }

    size_t index(ivec3 cell) const
    {
        const int n = solid.grid.resolution;
        return size_t(cell.x) + size_t(n) * (size_t(cell.y) + size_t(n) * size_t(cell.z));
    }

    // Puts so many full cells on top of each other, from the first above what is solid.
    void pour(ivec3 cell, int height)
    {
        while (solid.grid.solid(cell)) ++cell.y;
        bind_storage(COVER_BUFFER);
        for (int i = 0; i < height; ++i, ++cell.y) {
            glBufferSubData(GL_SHADER_STORAGE_BUFFER, GLintptr(index(cell) * sizeof full),
                            sizeof full, &full);
        }
    }

    // The buffer that the shaders find at `binding`.
    void bind_storage(GLuint binding) const
    {
        cover.bind();
        GLint buffer = 0;
        glGetIntegeri_v(GL_SHADER_STORAGE_BUFFER_BINDING, binding, &buffer);
        glBindBuffer(GL_SHADER_STORAGE_BUFFER, GLuint(buffer));
    }

    uint64_t melted() const
    {
        uint64_t sums[2] = {};  // deposited, melted
        bind_storage(SUMS_BUFFER);
        glGetBufferSubData(GL_SHADER_STORAGE_BUFFER, 0, sizeof sums, sums);
        return sums[1];
    }

    void let_settle(unsigned rounds)
    {
        weather_block.update(WEATHER_BLOCK, window.options().weather);
        solid.bind();
        columns.settle(64 * rounds, int(64 * rounds));
    }

    // Height of the snow in the column of `cell`, on what is below, in cells.
    double height(const std::vector<GLuint>& mass, ivec3 cell) const
    {
        while (solid.grid.solid(cell)) ++cell.y;
        double sum = 0;
        for (; mass[index(cell)] > 0; ++cell.y) sum += double(mass[index(cell)]) / full;
        return sum;
    }

    static uint64_t sum(const std::vector<GLuint>& mass)
    {
        return std::accumulate(mass.begin(), mass.end(), uint64_t(0));
    }

    Harness window{command()};
    const double slope = std::tan(glm::radians(window.options().weather.repose));  // the steepest
    SolidScene solid{window};
    SnowCover cover{solid.grid.resolution, solid.grid.resolution};
    Columns columns{solid, cover};
    UniformBlock<snow::Weather> weather_block;
};

TEST_F(SnowThatLies, BecomesAConeOfTheAngleOfRepose)
{
    const ivec3 middle(20, 0, 20);
    pour(middle, 40);
    for (int side : {-1, 1}) {
        pour(middle + ivec3(side, 0, 0), 40);
        pour(middle + ivec3(0, 0, side), 40);
    }
    let_settle(60);
    const std::vector<GLuint> mass = cover.read();
    EXPECT_EQ(sum(mass), uint64_t(5 * 40) * full);

    for (int x = 4; x < 36; ++x) {
        for (int z = 4; z < 36; ++z) {
            const ivec3 cell(x, 0, z);
            for (const ivec3 side :
                 {ivec3(1, 0, 0), ivec3(0, 0, 1), ivec3(1, 0, 1), ivec3(1, 0, -1)}) {
                // A tenth of a cell more: the last of it slides ever more slowly.
                EXPECT_LE(std::abs(height(mass, cell) - height(mass, cell + side)),
                          slope * glm::length(glm::vec3(side)) + 0.1)
                    << x << ", " << z;
            }
        }
    }
    // And no flatter: that of a cone of this volume. A tenth: the pile is an octagon.
    const double expected = std::cbrt(3 * 5 * 40 * slope * slope / glm::pi<double>());
    EXPECT_NEAR(height(mass, middle), expected, 0.1 * expected);
}

TEST_F(SnowThatLies, SlidesOverTheEdgeOfATable)
{
    const auto cell_at = [&](float x, float y, float z) {
        return ivec3((glm::vec3(x, y, z) - solid.grid.origin) / solid.grid.cell_size);
    };
    for (float x = 2.5f; x < 5.6f; x += solid.grid.cell_size) pour(cell_at(x, 2, 2.3f), 20);
    const uint64_t before = sum(cover.read());
    let_settle(60);
    const std::vector<GLuint> mass = cover.read();
    EXPECT_EQ(sum(mass), before);
    EXPECT_GT(height(mass, cell_at(4, 0, 1.7f)), 1) << "beside the table";
    EXPECT_GT(height(mass, cell_at(4, 2, 3)), 1) << "on the table";
    EXPECT_EQ(height(mass, cell_at(4, 0, 4)), 0) << "under the table";
}

TEST_F(SnowThatLies, MeltsFasterTheWarmerItIs)
{
    const ivec3 cell(20, 0, 20);
    pour(cell, 10);
    snow::Weather thaw = window.options().weather;
    double lost_before = 0;
    for (const float degrees : {-5.0f, 0.0f, 5.0f, 10.0f}) {
        thaw.temperature = degrees;
        weather_block.update(WEATHER_BLOCK, thaw);
        const double before = height(cover.read(), cell);
        solid.bind();
        columns.melt(640, 640, thaw);
        const std::vector<GLuint> mass = cover.read();
        const double lost = before - height(mass, cell);
        EXPECT_EQ(sum(mass) + melted(), uint64_t(10) * full);
        EXPECT_EQ(lost > 0, degrees > 0) << degrees;
        if (degrees == 10) {
            EXPECT_NEAR(lost, 2 * lost_before, 20.0 / full)
                << "a part of a unit is cut off each time";
        }
        lost_before = lost;
    }
}

}  // namespace
