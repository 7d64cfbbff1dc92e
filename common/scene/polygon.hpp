// Divides polygons into triangles, those with corners that point inwards too.
#pragma once

#include <cstddef>
#include <glm/glm.hpp>
#include <vector>

// Cuts off one ear after the other: a corner that points outwards and whose triangle holds no other
// corner (Meisters 1975, "Polygons have ears"). The ear with the shortest cut goes first, which
// avoids slivers. Returns the indices of n - 2 triangles that run the same way around as `corners`;
// so it does for polygons that no triangles could fill, without area or crossing themselves. The
// time it takes grows with n^2.
std::vector<size_t> cut_into_triangles(const std::vector<glm::dvec3>& corners);
