// Where flakes come into the air around the scene: out of their cloud, on the wind, or with --follow from the
// other side. Never under a roof or in a wall.

#include "common/weather_block.glsl"
#include "step05_collision/terrain.glsl"

bool open_sky(vec3 position);  // does nothing stand there, or above?

// The flake is born. Returns false if it would be where none can come in: then it waits for the next time step.
bool release(out Particle p, uint index, uint tick)
{
    p = born(index, tick, weather);
    p.position.y += terrain_at(p.position);  // its cloud hangs above the ground
    if (!wind_takes_flakes(weather) || open_sky(p.position)) return true;
    p = unborn(index, weather);
    p.age = -weather.time_step;
    return false;
}

// Takes the flake to the other side if it has left (see wrapped in common/snow.glsl), as high above the ground
// there as it was here. Returns false if no snow can be falling there: then it is to be born again.
bool goes_on(inout Particle p, uint index)
{
    vec3 before = p.position;
    p = wrapped(p, index, weather);
    if (p.position == before) return true;
    p.position.y += terrain_at(p.position) - terrain_at(before);
    return open_sky(p.position);
}
