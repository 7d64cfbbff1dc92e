// How many triangles the whole winter draws, in a window of its own.
#include <gtest/gtest.h>

#include "common/harness/files.hpp"
#include "step06_accumulation/cover/snow_cover.hpp"
#include "step06_accumulation/winter/winter.hpp"
#include "tests/common/harness/small_window.hpp"

// What is not to be divided has the level 1, and is as many triangles as without tessellation: or
// an edge would be divided on one side, and not on the other, where that is not tessellated.
TEST(Tessellation, DividesNothingWhereNoSnowLies)
{
    CommandLine command = small_window(4.3, 2);
    command.lesson.has_scene = true;
    command.scene = find_file("common/assets/courtyard.obj");
    command.voxels = 128;  // so fine that there is something to divide
    command.frames = 1;
    Window window(command);
    SnowCover cover(command.voxels);
    const SolidScene solid(window);
    Columns columns(solid, cover);
    Winter winter(window, solid, columns);
    PingPong particles(make_flakes(command.weather));
    ASSERT_TRUE(window.begin_frame());
    GLuint query = 0, triangles[2] = {};
    glGenQueries(1, &query);
    for (const int tessellated : {0, 1}) {
        SnowSurface::tessellation = tessellated == 1;
        glBeginQuery(GL_PRIMITIVES_GENERATED, query);
        winter.draw(window, 0, particles);
        glEndQuery(GL_PRIMITIVES_GENERATED);
        glGetQueryObjectuiv(query, GL_QUERY_RESULT, &triangles[tessellated]);
    }
    glDeleteQueries(1, &query);
    EXPECT_GT(triangles[0], 1000u);
    EXPECT_LE(triangles[1], triangles[0]);  // what is out of sight is left out
}
