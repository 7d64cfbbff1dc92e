// How deep the snow lies, as depth.comp has measured it.

#include "step05_collision/grid.glsl"

uniform sampler3D snow_depth;  // m, on the surface nearest to each cell; less than 0: unknown

// m, at `point` of the scene.
float depth_at(vec3 point)
{
    vec3 place = (point - grid_origin) / (cell_size * float(resolution));
    return max(textureLod(snow_depth, place, 0.0).r, 0.0);
}
