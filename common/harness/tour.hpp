// A flight through the courtyard, or over another scene, for demonstrations and recordings: a
// closed loop that ends as it began.
#pragma once

#include <glm/glm.hpp>

#include "common/terrain.hpp"

// Where a camera is, and what it looks at.
struct Pose {
    glm::vec3 eye, target;  // m
};

constexpr float tour_seconds = 40;

// The pose `seconds` after the flight began: along Catmull-Rom splines between twelve points.
Pose tour(float seconds);

// The same of a flight once around the middle of a scene in its own metres, up and down with it.
Pose tour_above(const Terrain& terrain, float seconds);
