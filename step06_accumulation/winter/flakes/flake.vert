#version 430 core
// Hands a flake on to the geometry shader, as it is and in what light.

#include "step06_accumulation/winter/light/light.glsl"

layout(location = 0) in vec3 position;  // m
layout(location = 1) in float age;      // s
layout(location = 2) in vec3 velocity;  // m/s
layout(location = 3) in float rest;     // s

out Flake
{
    vec3 position;
    float age;
    vec3 velocity;
    float rest;
    uint index;
    vec3 colour;  // as the screen wants it
}
flake;

void main()
{
    flake.position = position;
    flake.age = age;
    flake.velocity = velocity;
    flake.rest = rest;
    flake.index = uint(gl_VertexID);
    flake.colour = tone_mapped(through_air(light_on_flake(position), position));
}
