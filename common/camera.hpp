// A camera that orbits a point, and flies with it.
#pragma once

#include <algorithm>
#include <cmath>
#include <glm/glm.hpp>
#include <glm/gtc/matrix_transform.hpp>

struct Camera {
    glm::vec3 target = {0, 1.6f, 0};  // m, the point looked at
    float azimuth = 0.72f;            // rad around the vertical, from +z towards +x
    float elevation = 0.27f;          // rad above the horizon
    float distance = 17.5f;           // m from the target
    float field_of_view = 0.82f;      // rad, vertical

    glm::vec3 eye() const
    {
        const float across = std::cos(elevation);
        return target + distance * glm::vec3(across * std::sin(azimuth), std::sin(elevation),
                                             across * std::cos(azimuth));
    }
    glm::mat4 view() const { return glm::lookAt(eye(), target, {0, 1, 0}); }
    glm::mat4 projection(glm::ivec2 window) const  // near and far plane at 0.1 m and 2 km
    {
        return glm::perspective(field_of_view, float(window.x) / float(window.y), 0.1f, 2000.0f);
    }

    // Puts the eye there, m, looking at `point`.
    void look(glm::vec3 from, glm::vec3 point)
    {
        const glm::vec3 back = from - point;
        target = point;
        distance = glm::length(back);
        azimuth = std::atan2(back.x, back.z);
        elevation = std::asin(back.y / distance);
    }

    void orbit(glm::vec2 pixels)  // by half a degree a pixel, short of the poles
    {
        azimuth -= pixels.x * 0.0087f;
        elevation = std::clamp(elevation + pixels.y * 0.0087f, -0.05f, 1.5f);
    }
    void fly(glm::vec3 by)  // m to the right, up, and ahead
    {
        const glm::mat3 axes = glm::transpose(glm::mat3(view()));
        target += axes * glm::vec3(by.x, by.y, -by.z);
    }
    void pan(glm::vec2 pixels, int window_height)  // what it looks at stays under the mouse
    {
        const float pixel = 2 * distance * std::tan(field_of_view / 2) / float(window_height);  // m
        fly({-pixels.x * pixel, pixels.y * pixel, 0});
    }
    void zoom(float notches)
    {
        distance = std::clamp(distance * std::pow(0.9f, notches), 0.5f, 80.0f);
    }
};
