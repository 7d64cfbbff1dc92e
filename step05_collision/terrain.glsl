// How high the ground stands where a scene keeps its own metres; 0 in all others. Clouds hang as high above it
// as elsewhere above y = 0.

#include "step05_collision/grid.glsl"

layout(binding = TERRAIN_UNIT) uniform sampler2D terrain;  // m, see common/terrain.hpp

float terrain_at(vec3 position)
{
    return textureLod(terrain, 0.5 + 0.5 * position.xz / grid.terrain_half_size, 0.0).r;
}
