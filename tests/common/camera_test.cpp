#include "common/camera.hpp"

#include <gtest/gtest.h>

#include "common/files.hpp"
#include "common/harness/tour.hpp"
#include "step05_collision/voxel_grid.hpp"

TEST(Camera, KeepsItsDistanceAndItsHeadUp)
{
    Camera camera;
    for (const glm::vec2 drag : {glm::vec2(1e4f, 0), glm::vec2(0, 1e4f), glm::vec2(0, -3e4f)}) {
        camera.orbit(drag);
        EXPECT_NEAR(glm::distance(camera.eye(), camera.target), camera.distance, 1e-4);
        const glm::vec3 up = glm::transpose(glm::mat3(camera.view()))[1];
        EXPECT_GT(up.y, 0) << "past a pole the picture would stand on its head";
    }
}

// Frame by frame, twice around: no speed above 3 m/s, no jerk, no turn faster than 1 rad/s.
TEST(Tour, IsSmooth)
{
    const float frame = 1 / 60.0f;  // s
    const auto direction = [](float seconds) {
        const Pose view = tour(seconds);
        return glm::normalize(view.target - view.eye);
    };
    for (float t = 0; t < 2 * tour_seconds; t += frame) {
        const glm::vec3 before = (tour(t).eye - tour(t + frame).eye) / frame;
        const glm::vec3 after = (tour(t + frame).eye - tour(t + 2 * frame).eye) / frame;
        EXPECT_LT(glm::length(before), 3) << "m/s at " << t;
        EXPECT_LT(glm::distance(before, after), 0.06) << "m/s in a frame, at " << t;
        EXPECT_LT(glm::distance(direction(t), direction(t + frame)), frame) << "rad at " << t;
    }
}

// Not through the next voxel either: that far, 0.13 m, the near plane does not reach.
TEST(Tour, LeadsThroughNothingSolid)
{
    const VoxelGrid grid = voxelise(load_scene(find_file("common/assets/courtyard.obj"), 'y'), 128);
    for (float t = 0; t < tour_seconds; t += 0.05f) {
        const glm::ivec3 cell((tour(t).eye - grid.origin) / grid.cell_size);
        for (int i = 0; i < 27; ++i) {
            const glm::ivec3 neighbour(i % 3 - 1, i / 3 % 3 - 1, i / 9 - 1);
            EXPECT_FALSE(grid.solid(cell + neighbour)) << "s " << t;
        }
    }
}

TEST(TourAbove, IsALoopThatKeepsClearOfTheMountains)
{
    const Terrain terrain =
        terrain_of(load_scene(find_file("common/assets/mountains.obj"), 'y', nullptr, true));
    EXPECT_GT(terrain.highest({0, 0}, 200), 60);
    constexpr float frame = 1 / 60.0f;  // s
    for (float t = 0; t < tour_seconds; t += frame) {
        const glm::vec3 eye = tour_above(terrain, t).eye;
        EXPECT_GT(eye.y, terrain.highest({eye.x, eye.z}, 0) + 1) << t;  // squares of 3 m
        EXPECT_LT(glm::distance(eye, tour_above(terrain, t + frame).eye) / frame, 25) << t;
    }
}
