// Does a triangle touch a box? The separating-axis test of Akenine-Moller, "Fast 3D Triangle-Box
// Overlap Testing" (2001): the two are apart if their shadows are apart on one of 13 axes.
#pragma once

#include <glm/glm.hpp>

// a, b, c: the corners; centre, half_size: of the axis-aligned box. Touching counts.
inline bool triangle_touches_box(glm::vec3 a, glm::vec3 b, glm::vec3 c, glm::vec3 centre,
                                 glm::vec3 half_size)
{
    using glm::vec3;
    a -= centre;  // from here on the box lies around the origin
    b -= centre;
    c -= centre;

    // 1-3: the axes of the box.
    const vec3 minimum = glm::min(a, glm::min(b, c)), maximum = glm::max(a, glm::max(b, c));
    if (glm::any(glm::greaterThan(minimum, half_size)) ||
        glm::any(glm::lessThan(maximum, -half_size)))
        return false;

    // 4: the normal of the triangle.
    const vec3 edges[] = {b - a, c - b, a - c};
    const vec3 normal = glm::cross(edges[0], edges[1]);
    if (glm::abs(glm::dot(normal, a)) > glm::dot(glm::abs(normal), half_size)) return false;

    // 5-13: edge x box axis, for each of the three edges and axes.
    for (const vec3& edge : edges) {
        for (const vec3& axis :
             {vec3(0, -edge.z, edge.y), vec3(edge.z, 0, -edge.x), vec3(-edge.y, edge.x, 0)}) {
            const float pa = glm::dot(axis, a), pb = glm::dot(axis, b), pc = glm::dot(axis, c);
            const float reach = glm::dot(glm::abs(axis), half_size);
            if (glm::min(pa, glm::min(pb, pc)) > reach || glm::max(pa, glm::max(pb, pc)) < -reach)
                return false;
        }
    }
    return true;
}
