// Parts of the winter that need OpenGL, in windows of their own.
#include <gtest/gtest.h>

#include <set>

#include "common/files.hpp"
#include "step06_accumulation/cover/columns.hpp"
#include "step06_accumulation/winter/flakes/depth_order.hpp"
#include "step06_accumulation/winter/frame_block.hpp"
#include "step06_accumulation/winter/permutations.hpp"
#include "step06_accumulation/winter/surface/snow_surface.hpp"
#include "tests/common/harness/small_window.hpp"

namespace {

CommandLine on(const std::string& scene, int voxels, unsigned flakes = 7)
{
    CommandLine command = small_window(4.3, flakes);
    command.lesson.has_scene = true;
    command.scene = scene;
    command.voxels = voxels;
    command.frames = 2;
    return command;
}

// A frame that has begun, and what all shaders are told of it.
struct Frame {
    explicit Frame(const CommandLine& command) : window(command), solid(window), block(solid)
    {
        EXPECT_TRUE(window.begin_frame());
        weather_block.update(WEATHER_BLOCK, command.weather);
        block.update(window, Settings{}, 0);
    }

    Harness window;
    SolidScene solid;
    FrameBlock block;
    UniformBlock<snow::Weather> weather_block;
};

class DepthOrderOf : public testing::TestWithParam<unsigned> {};

}  // namespace

// An `if` in a shader is not enough: there are drivers that compute both of its sides.
TEST(Permutations, HaveNotALineOfWhatIsOff)
{
    const Harness window(small_window(4.3));
    const std::string folder = "step06_accumulation/winter/surface/";
    Permutations all(
        {{GL_VERTEX_SHADER, folder + "bare.vert"}, {GL_FRAGMENT_SHADER, folder + "bare.frag"}},
        SHADOW | OCCLUSION);
    const auto has_texture = [&](unsigned features, const char* name) {
        all.use(features);
        GLint program = 0;
        glGetIntegerv(GL_CURRENT_PROGRAM, &program);
        return glGetUniformLocation(GLuint(program), name) >= 0;
    };
    EXPECT_TRUE(has_texture(SHADOW | OCCLUSION, "shadow_map"));
    EXPECT_TRUE(has_texture(SHADOW | OCCLUSION, "sky_visibility"));
    EXPECT_FALSE(has_texture(SHADOW, "sky_visibility"));
    EXPECT_FALSE(has_texture(OCCLUSION, "shadow_map"));
    // Nothing is compiled twice, nor for what the shaders do not ask for.
    EXPECT_EQ(&all.use(SHADOW), &all.use(SHADOW | BLOOM));
}

// Where the screen is faster than the snow, a frame makes no step: its flakes are those of the
// frame before, and so are their streaks.
TEST(FrameBlock, KeepsTheShutterInAFrameWithoutAStep)
{
    Harness window(on("none", 32));
    const SolidScene solid(window);
    FrameBlock block(solid);
    std::vector<float> shutters;
    while (window.begin_frame()) {
        if (shutters.empty()) window.next_tick();
        shutters.push_back(block.update(window, Settings{}, 1).shutter);
        window.swap_buffers();
    }
    EXPECT_EQ(shutters, std::vector<float>(2, window.options().weather.time_step));
}

// When it stops snowing; and it loses as much to a thaw as the cover.
TEST(FrameBlock, KeepsTheSnowOfTheField)
{
    Frame frame(on("none", 32));
    auto& weather = const_cast<snow::Weather&>(frame.window.options().weather);  // as a slider does
    const auto depth_after = [&](unsigned minutes) {
        return frame.block.update(frame.window, Settings{}, minutes * 3600).field_depth;
    };
    const float snow = depth_after(10);
    EXPECT_GT(snow, 9 * weather.snowfall);
    weather.snowfall = 0;
    EXPECT_EQ(depth_after(11), snow);
    weather.temperature = 5;
    EXPECT_NEAR(depth_after(12), snow - 0.05f, 1e-5f);  // melt.comp: 1 cm a minute and degree
}

// What is not to be divided has the level 1, and is as many triangles as without tessellation: or
// an edge would be divided on one side, and not on the other, where that is not tessellated.
TEST(Tessellation, DividesNothingWhereNoSnowLies)
{
    // So fine that there is something to divide.
    const CommandLine command = on(find_file("common/assets/courtyard.obj").string(), 128);
    const Frame frame(command);
    const SnowCover cover(command.voxels, command.voxels);
    const Columns columns(frame.solid, cover);
    SnowSurface surface(frame.solid);
    frame.solid.bind();
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

// From the farthest to the nearest: every flake that lives is there once.
TEST_P(DepthOrderOf, SortsThoseThatLive)
{
    const Frame frame(on("none", 32, GetParam()));
    std::vector<snow::Particle> flakes = make_flakes(frame.window.options().weather);
    for (unsigned i = 0; i < flakes.size(); ++i)
        flakes[i] = born(i, i % 3, frame.window.options().weather);
    const LiveFlakes live(GetParam(), 0.6f);
    DepthOrder order(GetParam());
    order.sort(ParticleBuffer(flakes), live);

    std::set<unsigned> alive;
    for (const int half : {0, 1}) {
        for (int i = 0; i < live.count[half]; ++i) alive.insert(unsigned(live.first[half] + i));
    }
    std::vector<unsigned> sorted(alive.size());
    glBindBuffer(GL_SHADER_STORAGE_BUFFER, order.order());
    glGetBufferSubData(GL_SHADER_STORAGE_BUFFER, 0, GLsizeiptr(sorted.size() * sizeof(unsigned)),
                       sorted.data());
    EXPECT_EQ(std::set<unsigned>(sorted.begin(), sorted.end()), alive);
    const auto distance = [&](unsigned i) {
        return -(frame.window.view() * glm::vec4(flakes[i].position, 1)).z;
    };
    // 1e-4 m: the card may round otherwise.
    for (size_t i = 1; i < sorted.size(); ++i)
        ASSERT_GE(distance(sorted[i - 1]) + 1e-4f, distance(sorted[i])) << i;
}

// One, few, a power of two, and what is none: up to many groups of the shader's.
INSTANTIATE_TEST_SUITE_P(Counts, DepthOrderOf, testing::Values(1u, 5u, 4096u, 30001u));
