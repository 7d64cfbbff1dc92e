#include "common/camera.hpp"

#include <gtest/gtest.h>

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
