#version 430 core
// Notes how deep the snow lies, in a 3D texture that the surface is lifted by: in a column of its own
// cell, of one below and of one above, on every surface, so that a neighbour a little higher or lower
// finds it at its own height.

#include "step06_accumulation/column.glsl"

layout(r16f, binding = 0) uniform image3D snow_depth;  // m; -1: unknown, within walls and outside

const ivec3 up = ivec3(0, 1, 0);

// Depth of the snow, m, from `cell`, the first above a surface, up to where it ends.
float depth_from(ivec3 cell)
{
    uint sum = 0u;
    for (; cell.y < resolution && mass_in(cell) > 0u; ++cell.y) sum += mass_in(cell);
    return float(sum) * (cell_size / float(full_cell));
}

void main()
{
    ivec3 cell = foot_of_column();
    int surface = -1, next = -1;  // the first cell above the surface that this cell belongs to
    float depth = 0.0;
    for (cell.y = -2; cell.y < resolution; ++cell.y) {
        ivec3 ahead = cell + 2 * up;
        if (in_scene(ahead - up) && !in_scene(ahead)) next = ahead.y;
        if (next >= 0 && (surface < 0 || cell.y > surface)) {
            surface = next;
            next = -1;
            depth = depth_from(ivec3(cell.x, surface, cell.z));
        }
        if (surface < 0 || cell.y < 0) continue;
        float now = cell.y <= surface + 1 ? depth : in_scene(cell) ? -1.0 : 0.0;
        float before = imageLoad(snow_depth, cell).r;
        // Half the way there each time: what fell as a flake appears as a soft growth.
        if (before >= 0.0 && now >= 0.0) now = 0.5 * (before + now);
        if (now != before) imageStore(snow_depth, cell, vec4(now));
    }
}
