// How deep the snow lies on what is seen from above. On all that is below there is none.

#include "step06_accumulation/heightmap/height_map.glsl"

layout(binding = DEPTH_UNIT) uniform usamplerBuffer lying;  // units in each column, as in snow_cover.glsl

// m, at `point` of the scene: the mean of the 4 x 4 columns around that are as high, the nearer the more.
float depth_at(vec3 point)
{
    vec2 columns = (point.xz - grid.origin.xz) / grid.cell_size - 0.5;
    float sum = 0.0, known = 0.0;
    for (int i = 0; i < 16; ++i) {
        ivec2 column = ivec2(floor(columns)) + ivec2(i & 3, i >> 2) - 1;
        if (!in_map(column) || abs(height_at(column) - point.y) > 2.0 * grid.cell_size) continue;
        vec2 near = max(2.0 - abs(columns - vec2(column)), 0.0);
        sum += near.x * near.y * float(texelFetch(lying, index_of(column)).r);
        known += near.x * near.y;
    }
    return known < 0.01 ? 0.0 : sum / known / 65536.0 * grid.cell_size;
}
