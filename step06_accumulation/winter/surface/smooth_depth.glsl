// How deep the snow lies at a point of the scene, smooth across the cells.

#include "step06_accumulation/cover/snow_depth.glsl"

// x: depth of the snow, m, at `point` of the scene; y, z: how it rises along x and z. Blended between nine
// columns by a quadratic B-spline, which has no creases; columns of which nothing is known are left out.
vec3 snow_at(vec3 point)
{
    vec3 place = (point - grid_origin) / cell_size;
    ivec3 cell = ivec3(floor(place));
    vec2 t = fract(place.xz) - 0.5;  // from the middle of the column, in cells
    // Weights of the three columns along x and along z, and their derivatives.
    vec2 weight[3] = vec2[](0.5 * (0.5 - t) * (0.5 - t), 0.75 - t * t, 0.5 * (0.5 + t) * (0.5 + t));
    vec2 slope[3] = vec2[](t - 0.5, -2.0 * t, t + 0.5);
    vec3 sum = vec3(0.0), weights = vec3(0.0);
    for (int x = 0; x < 3; ++x) {
        for (int z = 0; z < 3; ++z) {
            ivec3 column = clamp(cell + ivec3(x - 1, 0, z - 1), ivec3(0), ivec3(resolution - 1));
            float depth = texelFetch(snow_depth, column, 0).r;
            if (depth < 0.0) continue;
            vec3 w = vec3(weight[x].x * weight[z].y, slope[x].x * weight[z].y, weight[x].x * slope[z].y);
            sum += w * depth;
            weights += w;
        }
    }
    if (weights.x < 0.01) return vec3(0.0);
    float depth = sum.x / weights.x;
    return vec3(depth, (sum.yz - depth * weights.yz) / (weights.x * cell_size));
}
