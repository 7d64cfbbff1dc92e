// Collision against voxels: the cost is that of the few cells on a flake's way, whatever the scene.

#include "common/snow.glsl"
#include "step05_collision/voxels.glsl"
#include "step05_collision/voxel_walk.glsl"
#include "step05_collision/open_sky.glsl"

bool solid(ivec3 cell)
{
    return in_scene(cell);
}
