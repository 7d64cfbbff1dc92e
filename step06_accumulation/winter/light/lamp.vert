#version 430 core
// Hands a point of the lamp's glass on to the screen.

#include "step06_accumulation/winter/camera/camera.glsl"

layout(location = 0) in vec3 position;
layout(location = 2) in vec3 colour;

out vec3 world_position;  // m
out vec3 own_light;

void main()
{
    world_position = position;
    own_light = colour;
    gl_Position = camera.projection * camera.view * vec4(position, 1.0);
}
