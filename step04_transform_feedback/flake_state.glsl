// The flake a vertex shader reads as it is, and writes as it will be.

#include "common/weather_block.glsl"
#include "step04_transform_feedback/flake_output.glsl"

uniform uint tick;  // number of the time step

layout(location = 0) in vec3 old_position;
layout(location = 1) in float old_age;
layout(location = 2) in vec3 old_velocity;
layout(location = 3) in float old_rest;

Particle load_flake()
{
    return Particle(old_position, old_age, old_velocity, old_rest);
}
