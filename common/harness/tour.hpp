// A flight through the courtyard, for demonstrations and recordings: a closed loop that ends as it
// began.
#pragma once

#include <glm/glm.hpp>

// Where a camera is, and what it looks at.
struct Pose {
    glm::vec3 eye, target;  // m
};

constexpr float tour_seconds = 40;

// The pose `seconds` after the flight began: along Catmull-Rom splines between twelve points.
Pose tour(float seconds);
