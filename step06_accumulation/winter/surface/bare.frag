#version 430 core
// A surface on which no snow can lie.

#include "step05_collision/picture.glsl"
#include "step06_accumulation/winter/light/light.glsl"

in vec3 world_position;  // m
in vec3 world_normal;
in vec3 base_colour;
in vec4 air;             // see air.glsl

out vec4 colour;

void main()
{
    vec3 normal = normalize(gl_FrontFacing ? world_normal : -world_normal);  // towards the viewer
    float sunlight = sunlight_at(world_position + 0.03 * normal);            // beside it, out of its own shadow
    colour = vec4(air.rgb + air.a * lit(with_picture(base_colour), normal, world_position, sunlight, 0.0), 1.0);
}
