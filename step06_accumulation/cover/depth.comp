#version 430 core
// Notes how deep the snow lies, in a 3D texture that the surface is lifted by: on every surface, in a cell
// of the scene, in one below and in one above, so that a neighbour a little higher or lower finds it at
// its own height.

#include "step06_accumulation/cover/column.glsl"

layout(rg16f, binding = DEPTH_IMAGE) uniform image3D snow_depth;  // see snow_depth.glsl

const ivec3 up = ivec3(0, 1, 0);

// One flake stands for many, and leaves a lump: drawn is, turn after turn, a little of it and much of what
// was drawn around. So lumps spread out over some cells, and what fell as a flake appears as a soft growth.
float smoothed(float depth, ivec3 lying)
{
    float sum = 0.0, count = 0.0;
    for (int x = -1; x <= 1; ++x) {
        for (int z = -1; z <= 1; ++z) {
            float neighbour = imageLoad(snow_depth, lying + ivec3(x, 0, z)).r;
            if (neighbour == 0.0 && ivec2(x, z) != ivec2(0)) continue;  // bare, or a wall
            sum += neighbour;
            count += 1.0;
        }
    }
    return depth > 0.0 ? mix(depth, sum / count, 0.9) : 0.0;
}

void take_turn(ivec3 cell)
{
    int lower = -1;  // height of the first cell above the surface below, where there is one
    for (; next_surface(cell); lower = cell.y) {
        uint sum = 0u;
        for (ivec3 above = cell; mass_in(above) > 0u; above += up) sum += mass_in(above);
        float depth = float(sum) * (grid.cell_size / float(full_cell));
        for (int y = max(cell.y - 2, lower + 1); y <= cell.y; ++y) {
            ivec3 lying = ivec3(cell.x, y, cell.z);
            imageStore(snow_depth, lying, vec4(smoothed(depth, lying), 1.0, 0.0, 0.0));
        }
    }
}
