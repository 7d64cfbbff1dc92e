#version 430 core
// The variant "winter": the air flows around the scene, and only flakes that live are moved.

#include "step06_accumulation/cover/update.glsl"
#include "step06_accumulation/cover/deposit.glsl"
#include "step06_accumulation/winter/flakes/live.glsl"
#include "step06_accumulation/winter/wind/wind_field.glsl"

vec3 air_at(vec3 position)
{
    return wind_at(position, tick);
}

void main()
{
    if (lives(first + gl_GlobalInvocationID.x)) update_flake();
}
