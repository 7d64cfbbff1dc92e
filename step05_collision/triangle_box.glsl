// Does a triangle touch a box? The separating-axis test of Akenine-Moller, "Fast 3D Triangle-Box
// Overlap Testing" (2001): the two are apart if their shadows are apart on one of 13 axes. GLSL and
// C++, like common/snow.glsl.

// a, b, c: the corners; centre, half_size: of the axis-aligned box. Touching counts.
SNOW_INLINE bool triangle_touches_box(vec3 a, vec3 b, vec3 c, vec3 centre, vec3 half_size)
{
    a -= centre;  // from here on the box lies around the origin
    b -= centre;
    c -= centre;

    // 1-3: the axes of the box.
    vec3 least = min(a, min(b, c)), most = max(a, max(b, c));
    if (any(greaterThan(least, half_size)) || any(lessThan(most, -half_size))) return false;

    // 4: the normal of the triangle.
    vec3 edges[3];
    edges[0] = b - a;
    edges[1] = c - b;
    edges[2] = a - c;
    vec3 normal = cross(edges[0], edges[1]);
    if (abs(dot(normal, a)) > dot(abs(normal), half_size)) return false;

    // 5-13: edge x box axis, for each of the three edges and axes.
    for (int i = 0; i < 3; ++i) {
        for (int k = 0; k < 3; ++k) {
            vec3 axis = k == 0   ? vec3(0.0f, -edges[i].z, edges[i].y)
                        : k == 1 ? vec3(edges[i].z, 0.0f, -edges[i].x)
                                 : vec3(-edges[i].y, edges[i].x, 0.0f);
            float pa = dot(axis, a), pb = dot(axis, b), pc = dot(axis, c);
            float reach = dot(abs(axis), half_size);
            if (min(pa, min(pb, pc)) > reach || max(pa, max(pb, pc)) < -reach) return false;
        }
    }
    return true;
}
