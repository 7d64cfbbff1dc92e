#version 430 core
// Lifts a point of the scene by the snow that lies on it.

#include "step06_accumulation/frame.glsl"
#include "step06_accumulation/snow_cover.glsl"


layout(location = 0) in vec3 position;
layout(location = 1) in vec3 normal;
layout(location = 2) in vec3 colour;
layout(location = 3) in float upward;  // is there a surface here that snow can lie on?

out vec3 world_position;  // m, on top of the snow
out vec3 world_normal;    // of the surface without snow
out vec3 base_colour;
out vec3 snow_normal;     // of the snow upon it
out float snow_depth;     // m

// Depth of the snow, m, in the column of `cell`, on the first surface at or above that cell.
float column_depth(ivec3 cell)
{
    for (int climb = 0; climb < 3 && in_scene(cell); ++climb) cell.y += 1;
    float cells = 0.0;
    for (int layer = 0; layer < 256; ++layer) {
        float filled = float(mass_in(cell)) / float(full_cell);
        if (filled == 0.0) break;
        cells += filled;
        cell.y += 1;
    }
    return cells * cell_size;
}

// At a point, blended between the four nearest columns: x the depth, m; yz how it rises along x and z.
vec3 depth_at(vec3 point)
{
    vec3 place = (point - grid_origin) / cell_size - vec3(0.5, 0.0, 0.5);  // 0.5: a column's middle
    ivec3 cell = ivec3(floor(place));
    vec2 part = fract(place.xz);
    float a = column_depth(cell), b = column_depth(cell + ivec3(1, 0, 0));
    float c = column_depth(cell + ivec3(0, 0, 1)), d = column_depth(cell + ivec3(1, 0, 1));
    return vec3(mix(mix(a, b, part.x), mix(c, d, part.x), part.y),
                mix(b - a, d - c, part.y) / cell_size, mix(c - a, d - b, part.x) / cell_size);
}

void main()
{
    vec3 depth = upward > 0.1 ? depth_at(position) : vec3(0.0);
    snow_depth = depth.x;
    world_position = position + vec3(0.0, snow_depth, 0.0);
    world_normal = normal;
    snow_normal = normalize(normal / max(normal.y, 0.2) - vec3(depth.y, 0.0, depth.z));
    base_colour = colour;
    gl_Position = frame.projection * frame.view * vec4(world_position, 1.0);
}
