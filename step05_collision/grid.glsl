// Where the voxels lie in the world, and how wide the ground around the middle is known: a uniform block that
// SolidScene fills. GLSL and C++, like common/snow.glsl.

struct Grid {
    vec3 origin;              // m, the corner of least x, y and z
    float cell_size;          // m, edge of a voxel
    int resolution;           // voxels along each edge
    float terrain_half_size;  // m, from the middle of terrain.glsl to its edge
    float unused, unused_too;  // fill the row of four
};

#ifndef __cplusplus
#include "common/bindings.glsl"

layout(std140, binding = GRID_BLOCK) uniform GridBlock
{
    Grid grid;
};
#endif
