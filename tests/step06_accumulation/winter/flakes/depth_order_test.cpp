// Flakes from the farthest to the nearest, in a real window.
#include "step06_accumulation/winter/flakes/depth_order.hpp"

#include <gtest/gtest.h>

#include <set>

#include "step06_accumulation/winter/frame_block.hpp"
#include "tests/common/harness/small_window.hpp"

class DepthOrderOf : public testing::TestWithParam<unsigned> {};

// Every flake that lives is there once, and none is farther than the one before it.
TEST_P(DepthOrderOf, SortsThoseThatLive)
{
    CommandLine command = small_window(4.3, GetParam());
    command.frames = 1;
    command.lesson.has_scene = true;
    command.scene = "none";
    command.voxels = 32;
    Harness window(command);
    std::vector<snow::Particle> flakes = make_flakes(command.weather);
    for (unsigned i = 0; i < flakes.size(); ++i) flakes[i] = born(i, i % 3, command.weather);
    const ParticleBuffer particles(flakes);
    const LiveFlakes live(GetParam(), 0.6f);
    const SolidScene solid(window);
    FrameBlock frame(solid);
    UniformBlock<snow::Weather> weather_block;
    DepthOrder order(GetParam());
    ASSERT_TRUE(window.begin_frame());
    weather_block.update(WEATHER_BLOCK, command.weather);
    frame.update(window, Settings{}, 1);
    order.sort(particles, live);

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
        return -(window.view() * glm::vec4(flakes[i].position, 1)).z;
    };
    for (size_t i = 1; i < sorted.size(); ++i) {
        // 1e-4 m: the card may round otherwise.
        ASSERT_GE(distance(sorted[i - 1]) + 1e-4f, distance(sorted[i])) << i;
    }
}

// One, a power of two, and what is none: up to many groups of the shader's.
INSTANTIATE_TEST_SUITE_P(Counts, DepthOrderOf, testing::Values(1u, 2u, 5u, 1000u, 4096u, 30001u));
