// In wind, and with --follow, what leaves the air under a cloud on one side enters on the other: see wrapped in
// common/snow.glsl.

#include "common/weather_block.glsl"
#include "step05_collision/terrain.glsl"

bool open_sky(vec3 position);  // does nothing stand there, or above?

// Takes the flake to the other side if it has left, as high above the ground there as it was here. Returns false
// if no snow can be falling there, under a roof or in a wall: then it is to be born again.
bool goes_on(inout Particle p, uint index)
{
    vec3 before = p.position;
    p = wrapped(p, index, weather);
    if (p.position == before) return true;
    p.position.y += terrain_at(p.position) - terrain_at(before);
    return open_sky(p.position);
}
