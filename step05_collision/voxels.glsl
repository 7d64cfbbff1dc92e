// The scene's voxel grid: one bit each, 32 along x in a texel.

uniform usampler3D voxels;
uniform vec3 grid_origin;  // m, the corner of least x, y and z
uniform float cell_size;   // m
uniform int resolution;    // voxels along each edge

bool in_grid(ivec3 cell)
{
    return all(greaterThanEqual(cell, ivec3(0))) && all(lessThan(cell, ivec3(resolution)));
}

bool in_scene(ivec3 cell)
{
    if (!in_grid(cell)) return false;
    uint word = texelFetch(voxels, ivec3(cell.x >> 5, cell.y, cell.z), 0).r;
    return ((word >> uint(cell.x & 31)) & 1u) != 0u;
}
