#version 430 core
// How finely each edge of a triangle is divided: only where snow bends it, and only as far as it shows.

#include "step06_accumulation/winter/camera/camera.glsl"
#include "step06_accumulation/winter/surface/corner.glsl"
#include "step06_accumulation/winter/surface/smooth_depth.glsl"

layout(vertices = 3) out;

uniform float fine_enough;  // m, length of an edge that stays as it is

in Corner corner[];
out Corner control[];

// Depth of the snow in the column at `point`, m.
float roughly(vec3 point)
{
    ivec3 cell = clamp(ivec3(floor((point - grid_origin) / cell_size)), ivec3(0), ivec3(resolution - 1));
    return max(texelFetch(snow_depth, cell, 0).r, 0.0);
}

// Depends on nothing but the edge, whichever triangle asks: so the two on its sides meet without a crack.
float edge_level(int a, int b)
{
    vec3 from = corner[a].position, to = corner[b].position;
    if (corner[a].lift + corner[b].lift == 0.0 || distance(from, to) <= fine_enough) return 1.0;
    vec3 middle = 0.5 * (from + to);
    // projection[1][1] is 1 / tan(half the field of view)
    float pixels_per_metre = 0.5 * float(camera.window_size.y) * camera.projection[1][1] /
                             max(distance(camera.eye, middle), 0.1);
    // How far the snow leaves the straight line between the ends, m.
    float first = roughly(from), last = roughly(to), bend = 0.0;
    for (int i = 1; i < 4; ++i) {
        float part = 0.25 * float(i);
        bend = max(bend, abs(roughly(mix(from, to, part)) - mix(first, last, part)));
    }
    const float least_pixels = 16.0;  // length of an edge that it pays to draw
    float finest = distance(from, to) * min(pixels_per_metre / least_pixels, 1.0 / cell_size);
    return mix(1.0, max(finest, 1.0), smoothstep(0.3, 1.5, bend * pixels_per_metre));
}

// Does the camera see nothing of the triangle, nor of what snow may make of it? Then all its corners lie beyond
// one and the same side of what it sees.
bool out_of_sight()
{
    float most = 1.0 + 2.0 * camera.field_depth;  // m, by which snow lifts it
    bvec4 beyond = bvec4(true);
    for (int i = 0; i < 3; ++i) {
        vec4 place = camera.projection * camera.view * vec4(corner[i].position, 1.0);
        // Of x and y, and of w.
        vec2 margin = most * (1.0 + vec2(camera.projection[0][0], camera.projection[1][1]));
        beyond = bvec4(beyond.x && place.x < -place.w - margin.x, beyond.y && place.x > place.w + margin.x,
                       beyond.z && place.y < -place.w - margin.y, beyond.w && place.y > place.w + margin.y);
    }
    return any(beyond);
}

void main()
{
    control[gl_InvocationID] = corner[gl_InvocationID];
    if (gl_InvocationID == 0 && out_of_sight()) {
        gl_TessLevelOuter[0] = gl_TessLevelOuter[1] = gl_TessLevelOuter[2] = 0.0;  // then there is no triangle
        gl_TessLevelInner[0] = 0.0;
    } else if (gl_InvocationID == 0) {
        // Edge i lies opposite to corner i.
        gl_TessLevelOuter[0] = edge_level(1, 2);
        gl_TessLevelOuter[1] = edge_level(2, 0);
        gl_TessLevelOuter[2] = edge_level(0, 1);
        gl_TessLevelInner[0] = max(gl_TessLevelOuter[0], max(gl_TessLevelOuter[1], gl_TessLevelOuter[2]));
    }
}
