// The flake an update shader reads, and the four outputs, in the layout of a Particle, that transform
// feedback captures.

#include "common/weather_block.glsl"

uniform uint tick;  // number of the time step

layout(location = 0) in vec3 old_position;
layout(location = 1) in float old_age;
layout(location = 2) in vec3 old_velocity;
layout(location = 3) in float old_rest;

out vec3 position;
out float age;
out vec3 velocity;
out float rest;

Particle load_flake()
{
    return Particle(old_position, old_age, old_velocity, old_rest);
}

void store_flake(Particle p)
{
    position = p.position;
    age = p.age;
    velocity = p.velocity;
    rest = p.rest;
}
