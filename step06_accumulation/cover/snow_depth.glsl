// How deep the snow lies, as depth.comp has measured it.

#include "step05_collision/grid.glsl"

// Red: depth, m, on the surface nearest to each cell. Green: 1. Within walls and in the air both are 0.
layout(binding = DEPTH_UNIT) uniform sampler3D snow_depth;

// m, at `point` of the scene. The card blends between columns, known or not: divided by the blend of the ones,
// their depths' blend is the mean of the known.
float depth_at(vec3 point)
{
    vec3 cells = (point - grid.origin) / grid.cell_size;
    cells.y = floor(cells.y) + 0.5;  // the middle of its layer: those above and below may be of other surfaces
    vec2 blend = textureLod(snow_depth, cells / float(grid.resolution), 0.0).rg;
    return blend.g < 0.01 ? 0.0 : blend.r / blend.g;
}
