// How high the ground stands where a scene keeps its own metres; 0 in all others. Clouds hang as high above it
// as elsewhere above y = 0.

uniform sampler2D terrain;        // m, see common/harness/terrain.hpp
uniform float terrain_half_size;  // m, from its middle to its edge

float terrain_at(vec3 position)
{
    return textureLod(terrain, 0.5 + 0.5 * position.xz / terrain_half_size, 0.0).r;
}
