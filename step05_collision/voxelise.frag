#version 420 core
// Marks the voxels of one column that the triangle touches.

#include "common/snow.glsl"
#include "step05_collision/grid.glsl"
#include "step05_collision/triangle_box.glsl"

layout(r32ui, binding = VOXELS_IMAGE) uniform uimage3D words;  // 32 voxels along x each

flat in vec3 a, b, c;
flat in int along;

void main()
{
    int across = (along + 1) % 3, up = (along + 2) % 3;
    ivec3 cell;
    cell[across] = int(gl_FragCoord.x);
    cell[up] = int(gl_FragCoord.y);
    // The column from the triangle's lowest corner to its highest.
    float low = (min(a[along], min(b[along], c[along])) - grid.origin[along]) / grid.cell_size;
    float high = (max(a[along], max(b[along], c[along])) - grid.origin[along]) / grid.cell_size;
    // And in that, where its plane passes: no more than a voxel above and below where it meets the column's
    // middle, as it is no steeper than 45 degrees; and one more for rounding.
    vec3 normal = cross(b - a, c - a);
    if (normal[along] != 0.0) {
        vec3 middle = grid.origin + grid.cell_size * (vec3(cell) + 0.5);
        float rise = normal[across] * (middle[across] - a[across]) + normal[up] * (middle[up] - a[up]);
        float height = (a[along] - rise / normal[along] - grid.origin[along]) / grid.cell_size;
        low = max(low, height - 2.0);
        high = min(high, height + 2.0);
    }
    int last = min(int(floor(high)) + 1, grid.resolution - 1);
    for (cell[along] = max(int(floor(low)) - 1, 0); cell[along] <= last; ++cell[along]) {
        vec3 half_size = vec3(0.5 * grid.cell_size);
        vec3 centre = grid.origin + grid.cell_size * vec3(cell) + half_size;
        if (triangle_touches_box(a, b, c, centre, half_size))
            imageAtomicOr(words, ivec3(cell.x >> 5, cell.y, cell.z), 1u << uint(cell.x & 31));
    }
}
