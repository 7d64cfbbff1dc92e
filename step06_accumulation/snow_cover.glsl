// The snow that lies: a mass for every cell of the voxel grid, in units of which full_cell fill it.
// Whole numbers, so that atomicAdd in any order gives the same sum, to the unit.

#include "step05_collision/voxels.glsl"

layout(std430, binding = 1) buffer SnowCover { uint mass[]; };

const uint full_cell = 65536u;

uint mass_index(ivec3 cell)
{
    return uint(cell.x + resolution * (cell.y + resolution * cell.z));
}

uint mass_in(ivec3 cell)
{
    return in_grid(cell) ? mass[mass_index(cell)] : 0u;
}

// What a flake lands on: the scene, or a cell that snow has filled.
bool solid(ivec3 cell)
{
    return in_scene(cell) || mass_in(cell) >= full_cell;
}
