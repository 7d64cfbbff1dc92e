#version 330 core
// A surface of the scene in its own colour, or with its picture.

#include "step05_collision/picture.glsl"
#include "step05_collision/shading.glsl"

in vec3 world_position;
in vec3 world_normal;
in vec3 base_colour;

out vec4 colour;

void main()
{
    vec3 surface = with_picture(base_colour);
    vec3 normal = normalize(gl_FrontFacing ? world_normal : -world_normal);  // towards the viewer
    colour = vec4(lit(surface, normal, world_position), 1.0);
}
