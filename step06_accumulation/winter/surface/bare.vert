#version 430 core
// A vertex of a surface on which no snow can lie.

#include "step06_accumulation/winter/light/air.glsl"

layout(location = 0) in vec3 position;
layout(location = 1) in vec3 normal;
layout(location = 2) in vec3 colour;
layout(location = 3) in vec2 uv;

out Place place;
out vec3 world_normal;
out vec3 base_colour;
out vec2 picture_uv;
out vec4 air;

void main()
{
    place = place_of(position, normal);
    world_normal = normal;
    base_colour = colour;
    picture_uv = uv;
    air = air_before(position);
    gl_Position = camera.projection * camera.view * vec4(position, 1.0);
}
