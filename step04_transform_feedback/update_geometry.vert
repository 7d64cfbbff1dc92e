#version 330 core
// Hands a flake, and which one it is, on to update.geom.

layout(location = 0) in vec3 position;
layout(location = 1) in float age;
layout(location = 2) in vec3 velocity;
layout(location = 3) in float rest;
layout(location = 4) in uint index;

out Flake
{
    vec3 position;
    float age;
    vec3 velocity;
    float rest;
    uint index;
}
flake;

void main()
{
    flake.position = position;
    flake.age = age;
    flake.velocity = velocity;
    flake.rest = rest;
    flake.index = index;
}
