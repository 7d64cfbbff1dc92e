#include "common/camera.hpp"

#include <gtest/gtest.h>

#include "common/files.hpp"
#include "common/harness/tour.hpp"
#include "step05_collision/voxel_grid.hpp"

TEST(Camera, SeesItsTargetInTheMiddle)
{
    Camera camera;
    camera.orbit({123, 45});
    const glm::mat4 to_screen = camera.projection({640, 360}) * camera.view();
    const glm::vec4 seen = to_screen * glm::vec4(camera.target, 1);
    // A pixel is 2/640: a thousandth of one is rounding.
    EXPECT_NEAR(seen.x / seen.w, 0, 3e-6);
    EXPECT_NEAR(seen.y / seen.w, 0, 3e-6);
    EXPECT_NEAR(seen.w, camera.distance, 1e-3);
}

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

TEST(Camera, ZoomsByNotchesWithinLimits)
{
    Camera camera;
    const float before = camera.distance;
    camera.zoom(1);
    EXPECT_LT(camera.distance, before);
    camera.zoom(-1);
    EXPECT_NEAR(camera.distance, before, 1e-4);
    camera.zoom(1000);
    EXPECT_GT(camera.distance, 0.1f) << "nearer than the near plane";
    camera.zoom(-1000);
    EXPECT_LT(camera.distance, 200) << "beyond the far plane";
}

TEST(Camera, DrawsCirclesRoundInAnyWindow)
{
    for (const glm::ivec2 window :
         {glm::ivec2(1280, 720), glm::ivec2(1, 1), glm::ivec2(100, 900)}) {
        const glm::mat4 projection = Camera{}.projection(window);
        EXPECT_NEAR(projection[0][0] * float(window.x), projection[1][1] * float(window.y),
                    1e-4 * float(window.y));
    }
}

TEST(Camera, LooksWhereItIsTold)
{
    Camera camera;
    for (const glm::vec3 eye : {glm::vec3(3, 2, 1), glm::vec3(-4, 0.5f, -2), glm::vec3(0, 9, -1)}) {
        const glm::vec3 point(1, 1.5f, -0.5f);
        camera.look(eye, point);
        EXPECT_NEAR(glm::distance(camera.eye(), eye), 0, 1e-5);
        EXPECT_EQ(camera.target, point);
    }
}

TEST(Tour, EndsAsItBegan)
{
    for (const float seconds : {0.0f, 0.1f, 17.3f}) {
        const Pose view = tour(seconds), again = tour(seconds + tour_seconds);
        EXPECT_NEAR(glm::distance(view.eye, again.eye), 0, 1e-4);
        EXPECT_NEAR(glm::distance(view.target, again.target), 0, 1e-4);
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
    EXPECT_FLOAT_EQ(terrain.half_size, 200);
    EXPECT_GT(terrain.highest({0, 0}, 200), 60);
    EXPECT_LT(terrain.highest({0, 20}, 1), 5);
    EXPECT_LT(glm::distance(tour_above(terrain, 0).eye, tour_above(terrain, tour_seconds).eye),
              0.1f);
    constexpr float frame = 1 / 60.0f;  // s
    for (float t = 0; t < tour_seconds; t += frame) {
        const glm::vec3 eye = tour_above(terrain, t).eye;
        EXPECT_GT(eye.y, terrain.highest({eye.x, eye.z}, 0) + 1) << t;  // squares of 3 m
        EXPECT_LT(glm::distance(eye, tour_above(terrain, t + frame).eye) / frame, 25) << t;
    }
}
