// Which way the surfaces of a scene face. Files leave it to chance: some have both sides of a
// sheet, some the wrong one, some a box inside out.
#pragma once

#include <glm/glm.hpp>
#include <vector>

#include "common/scene/obj.hpp"

// Of polygons that coincide leaves the first. Then makes those that share edges run the same way
// around, and turns each surface that they make as a whole: up, if it is rather a sheet, so that
// snow lies on its front; outwards, if as much of it faces down as up, as with a box or a ball.
// points: in world space.
void orient(std::vector<Polygon>& polygons, const std::vector<glm::vec3>& points);
