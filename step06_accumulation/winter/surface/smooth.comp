#version 430 core
// Notes how the snow looks from above, in a 3D texture which the card filters: for every cell at a surface of
// the scene how much of that is hidden, and how steep the snow lies there. What is nine lookups here is one in
// look.glsl.

#include "step06_accumulation/cover/column.glsl"
#include "step06_accumulation/winter/surface/snow_texture.glsl"

layout(r16f, binding = DEPTH_IMAGE) uniform readonly image3D snow_depth;  // m; less than 0: unknown
layout(rgba8, binding = SNOW_IMAGE) uniform writeonly image3D snow;

// Mean of nine columns `apart` cells from each other, so that no lump shows that a single flake has left, and
// the slope between them.
const int apart = 2;
const float weight[3] = float[](0.25, 0.5, 0.25);
const float slope[3] = float[](-0.5, 0.0, 0.5);

vec4 look_of(ivec3 place)
{
    float here = imageLoad(snow_depth, place).r;
    if (here < 0.0) return vec4(0.0);
    float depth = 0.0;
    vec2 rise = vec2(0.0);
    for (int x = 0; x < 3; ++x) {
        for (int z = 0; z < 3; ++z) {
            ivec3 column = clamp(place + apart * ivec3(x - 1, 0, z - 1), ivec3(0), ivec3(resolution - 1));
            float there = imageLoad(snow_depth, column).r;
            if (there < 0.0) there = here;
            depth += weight[x] * weight[z] * there;
            rise += vec2(slope[x] * weight[z], weight[x] * slope[z]) * there;
        }
    }
    return texel_of(depth, rise / (float(apart) * cell_size));
}

void take_turn(ivec3 cell)
{
    int lower = -1;  // as in depth.comp
    for (; next_surface(cell); lower = cell.y) {
        for (int y = max(cell.y - 2, lower + 1); y <= cell.y; ++y) {
            ivec3 place = ivec3(cell.x, y, cell.z);
            imageStore(snow, place, look_of(place));
        }
    }
}
