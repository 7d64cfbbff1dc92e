// Collision against the triangles of the scene, one after the other: exact, simple, and as slow as the scene is
// large. Kept for the comparison with voxels ("Simulating Snowfall and Accumulation Through the GPU", 3.2.3,
// tests all triangles for each flake, and proposes boxes around them).

#include "common/bindings.glsl"
#include "common/snow.glsl"

layout(binding = TRIANGLES_UNIT) uniform samplerBuffer triangles;  // three texels each: the corners, m

// Two texels each: a box's lowest corner, and its first triangle; its highest, and the first triangle behind.
layout(binding = BOXES_UNIT) uniform samplerBuffer boxes;

// Where the way from `from` along `way` meets a triangle: the fraction of the way, or 2 if it does not
// (Moller and Trumbore, "Fast, Minimum Storage Ray-Triangle Intersection", 1997).
float meet(vec3 from, vec3 way, vec3 a, vec3 b, vec3 c)
{
    vec3 across = cross(way, c - a);
    float determinant = dot(b - a, across);
    if (abs(determinant) < 1e-12) return 2.0;  // the way runs along the triangle
    vec3 s = from - a;
    float u = dot(s, across) / determinant;
    vec3 q = cross(s, b - a);
    float v = dot(way, q) / determinant;
    if (u < 0.0 || v < 0.0 || u + v > 1.0) return 2.0;
    float fraction = dot(c - a, q) / determinant;
    return fraction >= 0.0 && fraction <= 1.0 ? fraction : 2.0;
}

// The first triangle on the way: the fraction of the way to it, or 2 if there is none, and its normal.
float meet_first(vec3 from, vec3 way, out vec3 normal)
{
    float nearest = 2.0;
    vec3 least = min(from, from + way), most = max(from, from + way);
    for (int box = 0; box < textureSize(boxes); box += 2) {
        vec4 low = texelFetch(boxes, box), high = texelFetch(boxes, box + 1);
        if (any(lessThan(most, low.xyz)) || any(greaterThan(least, high.xyz))) continue;
        for (int i = int(low.w); i < int(high.w); ++i) {
            vec3 a = texelFetch(triangles, 3 * i).xyz;
            vec3 b = texelFetch(triangles, 3 * i + 1).xyz;
            vec3 c = texelFetch(triangles, 3 * i + 2).xyz;
            float fraction = meet(from, way, a, b, c);
            if (fraction < nearest) {
                nearest = fraction;
                normal = normalize(cross(b - a, c - a));
            }
        }
    }
    return nearest;
}

// Does no triangle hang above this point?
bool open_sky(vec3 position)
{
    vec3 up = vec3(0.0, 1000.0, 0.0), normal;  // m
    return meet_first(position, up, normal) > 1.0;
}

Particle collide(vec3 from, Particle p, Weather weather)
{
    const float gap = 0.0005;  // m, kept from a surface so that the next step starts outside of it
    const float nearly_down = 0.01;  // m, less than a flake is wide
    for (int slides = 0; slides < 3; ++slides) {
        vec3 way = p.position - from;
        vec3 normal;
        float nearest = meet_first(from, way, normal);
        if (nearest > 1.0) return p;
        if (dot(normal, way) > 0.0) normal = -normal;  // towards where the flake came from
        from += nearest * way + gap * normal;
        from.y = max(from.y, 0.0);  // where an overhang meets the ground there is less room than the gap
        if (normal.y > 0.1) {  // anything but a wall or a ceiling
            p.position = from;
            return land(p, weather);
        }
        vec3 slide = p.position - from;
        slide -= normal * dot(slide, normal);
        if (from.y + slide.y < 0.0) slide *= from.y / -slide.y;  // down an overhang, as far as to the ground
        p.position = from + slide;
        p.position.y = max(p.position.y, 0.0);
        p.velocity -= normal * dot(p.velocity, normal);
        if (p.position.y > nearly_down) p.rest = 0.0;  // only the straight way led to the ground
    }
    p.position = from;  // wedged in
    if (p.position.y > nearly_down) p.rest = 0.0;
    return p;
}
