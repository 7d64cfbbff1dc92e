// The scene's voxel grid: one bit each, 32 along x in a texel.

#include "step05_collision/grid.glsl"

layout(binding = VOXELS_UNIT) uniform usampler3D voxels;

bool in_grid(ivec3 cell)
{
    return all(greaterThanEqual(cell, ivec3(0))) && all(lessThan(cell, ivec3(grid.resolution)));
}

bool in_scene(ivec3 cell)
{
    if (!in_grid(cell)) return false;
    uint word = texelFetch(voxels, ivec3(cell.x >> 5, cell.y, cell.z), 0).r;
    return ((word >> uint(cell.x & 31)) & 1u) != 0u;
}
