#version 420 core
// Turns a triangle into all the columns of voxels that it may be in: the rectangle around it, as seen along
// the axis along which it looks largest. A pixel is a column.

#include "step05_collision/grid.glsl"

layout(triangles) in;
layout(triangle_strip, max_vertices = 4) out;

in vec3 corner[];

flat out vec3 a, b, c;  // m, the triangle
flat out int along;     // the axis along which the columns run

void main()
{
    vec3 normal = abs(cross(corner[1] - corner[0], corner[2] - corner[0]));
    int axis = normal.x > normal.y ? (normal.x > normal.z ? 0 : 2) : (normal.y > normal.z ? 1 : 2);
    vec3 least = min(corner[0], min(corner[1], corner[2])), most = max(corner[0], max(corner[1], corner[2]));
    // One more on each side, whatever rounding does: which voxels they touch is found out there.
    vec3 low = floor((least - grid.origin) / grid.cell_size) - 1.0;
    vec3 high = floor((most - grid.origin) / grid.cell_size) + 2.0;
    int across = (axis + 1) % 3, up = (axis + 2) % 3;
    for (int i = 0; i < 4; ++i) {
        a = corner[0];
        b = corner[1];
        c = corner[2];
        along = axis;
        vec2 cell = vec2((i & 1) == 0 ? low[across] : high[across], i < 2 ? low[up] : high[up]);
        gl_Position = vec4(2.0 * cell / float(grid.resolution) - 1.0, 0.0, 1.0);
        EmitVertex();
    }
}
