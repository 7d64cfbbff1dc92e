#version 430 core
// The variant "winter": the air flows around the scene.

#include "step04_transform_feedback/flake_state.glsl"
#include "step06_accumulation/winter/wind/wind_field.glsl"

vec3 air_at(vec3 position)
{
    return wind_at(position, tick);
}

#include "step06_accumulation/cover/update.glsl"
