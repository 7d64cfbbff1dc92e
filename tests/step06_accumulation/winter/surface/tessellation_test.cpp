// How many triangles the winter's surface is drawn with, in a window of its own.
#include <gtest/gtest.h>

#include "common/files.hpp"
#include "step06_accumulation/cover/columns.hpp"
#include "step06_accumulation/winter/frame_block.hpp"
#include "step06_accumulation/winter/surface/snow_surface.hpp"
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
    Harness window(command);
    const SolidScene solid(window);
    const SnowCover cover(command.voxels, command.voxels);
    const Columns columns(solid, cover);
    FrameBlock frame(solid);
    UniformBlock<snow::Weather> weather_block;
    SnowSurface surface(solid);
    ASSERT_TRUE(window.begin_frame());
    weather_block.update(WEATHER_BLOCK, command.weather);
    frame.update(window, Settings{}, 0);
    solid.bind();
    bind_texture(DEPTH_UNIT, GL_TEXTURE_3D, columns.depth());
    GLuint query = 0, triangles[2] = {};
    glGenQueries(1, &query);
    for (const bool tessellated : {false, true}) {
        glBeginQuery(GL_PRIMITIVES_GENERATED, query);
        surface.draw(0, tessellated);
        glEndQuery(GL_PRIMITIVES_GENERATED);
        glGetQueryObjectuiv(query, GL_QUERY_RESULT, &triangles[tessellated]);
    }
    glDeleteQueries(1, &query);
    EXPECT_GT(triangles[0], 1000u);
    EXPECT_LE(triangles[1], triangles[0]);  // what is out of sight is left out
}
