// Which way the corners of polygons face, where that is not simply as their triangle does.
#pragma once

#include <glm/glm.hpp>
#include <vector>

#include "common/scene/obj.hpp"

// Gives each corner in a smoothing group that the file has no normal for one of its own: the mean
// over the polygons of the group that meet in its point, each by its area. Of the normals that
// the file has it turns over those on the back of their polygon, and drops those of no length.
// polygons: as they shall face; normals: what their corners name, which grow; points: of both
// kinds in world space.
void complete_normals(std::vector<Polygon>& polygons, std::vector<glm::vec3>& normals,
                      const std::vector<glm::vec3>& points);
