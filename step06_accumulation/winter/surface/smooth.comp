#version 430 core
// Notes how the snow looks from above, in a 3D texture which the card filters: for every cell at a surface of
// the scene how much of that is hidden, and how steep the snow lies there. The nine lookups here are one in
// surface.frag.

#include "step06_accumulation/cover/column.glsl"
#include "step06_accumulation/winter/surface/snow_texture.glsl"

layout(rg16f, binding = DEPTH_IMAGE) uniform readonly image3D snow_depth;  // see snow_depth.glsl
layout(rgba8, binding = SNOW_IMAGE) uniform writeonly image3D snow_look;

// Mean of nine columns `apart` cells from each other, so that no lump shows that a single flake has left, and
// the slope between them.
const int apart = 2;
const float weight[3] = float[](0.25, 0.5, 0.25);
const float slope[3] = float[](-0.5, 0.0, 0.5);

vec4 look_of(ivec3 lying)
{
    vec2 here = imageLoad(snow_depth, lying).rg;
    if (here.g == 0.0) return vec4(0.0);
    float depth = 0.0;
    vec2 rise = vec2(0.0);
    for (int x = 0; x < 3; ++x) {
        for (int z = 0; z < 3; ++z) {
            ivec3 column = clamp(lying + apart * ivec3(x - 1, 0, z - 1), ivec3(0), ivec3(grid.resolution - 1));
            vec2 there = imageLoad(snow_depth, column).rg;
            if (there.g == 0.0) there = here;
            depth += weight[x] * weight[z] * there.r;
            rise += vec2(slope[x] * weight[z], weight[x] * slope[z]) * there.r;
        }
    }
    return texel_of(depth, rise / (float(apart) * grid.cell_size));
}

void take_turn(ivec3 cell)
{
    int lower = -1;  // as in depth.comp
    for (; next_surface(cell); lower = cell.y) {
        for (int y = max(cell.y - 2, lower + 1); y <= cell.y; ++y) {
            ivec3 lying = ivec3(cell.x, y, cell.z);
            imageStore(snow_look, lying, look_of(lying));
        }
    }
}
