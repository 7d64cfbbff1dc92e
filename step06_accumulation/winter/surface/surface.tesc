#version 430 core
// How finely each edge of a triangle is divided: only where snow bends it, and only as far as it shows.

#include "step06_accumulation/cover/snow_depth.glsl"
#include "step06_accumulation/winter/frame.glsl"
#include "step06_accumulation/winter/surface/corner.glsl"

layout(vertices = 3) out;

in Corner corner[];
out Corner control[];

// Depends on nothing but the edge, whichever triangle asks: so the two on its sides meet without a crack.
float edge_level(int a, int b)
{
    vec3 from = corner[a].position, to = corner[b].position;
    bool stays = corner[a].displacement + corner[b].displacement == 0.0;
    if (stays || distance(from, to) <= frame.fine_enough) return 1.0;
    vec3 middle = 0.5 * (from + to);
    // projection[1][1] is 1 / tan(half the field of view)
    float pixels_per_metre = 0.5 * float(frame.window_size.y) * frame.projection[1][1] /
                             max(distance(frame.eye, middle), 0.1);
    // How far the snow leaves the straight line between the ends, m.
    float first = depth_at(from), last = depth_at(to), bend = 0.0;
    for (int i = 1; i < 4; ++i) {
        float t = 0.25 * float(i);
        bend = max(bend, abs(depth_at(mix(from, to, t)) - mix(first, last, t)));
    }
    const float least_pixels = 16.0;  // length of an edge that it pays to draw
    float finest = distance(from, to) * min(pixels_per_metre / least_pixels, 1.0 / grid.cell_size);
    return mix(1.0, max(finest, 1.0), smoothstep(0.3, 1.5, bend * pixels_per_metre));
}

// Does the camera see nothing of the triangle, nor of what snow may make of it? Then all its corners lie beyond
// one and the same side of what it sees.
bool out_of_sight()
{
    float most = 1.0 + 2.0 * frame.field_depth;  // m, by which snow lifts it
    bvec4 beyond = bvec4(true);
    for (int i = 0; i < 3; ++i) {
        vec4 clip = frame.projection * frame.view * vec4(corner[i].position, 1.0);
        // In clip space, along x and y.
        vec2 margin = most * (1.0 + vec2(frame.projection[0][0], frame.projection[1][1]));
        beyond = bvec4(beyond.x && clip.x < -clip.w - margin.x, beyond.y && clip.x > clip.w + margin.x,
                       beyond.z && clip.y < -clip.w - margin.y, beyond.w && clip.y > clip.w + margin.y);
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
