#version 330 core
// A surface of the scene in its own colour.

#include "step05_collision/shading.glsl"

in vec3 world_position;
in vec3 world_normal;
in vec3 base_colour;

out vec4 colour;

void main()
{
    colour = vec4(lit(base_colour, normalize(world_normal), world_position), 1.0);
}
