#version 430 core
// A vertex of a surface on which no snow can lie; or of the field, which the snow on open ground lifts.

#include "step06_accumulation/winter/light/air.glsl"

layout(location = 0) in vec3 position;
layout(location = 1) in vec3 normal;
layout(location = 2) in vec3 colour;
layout(location = 3) in vec2 uv;
layout(location = 4) in float displacement;

out Spot spot;
out vec3 world_normal;
out vec3 base_colour;
out vec2 picture_uv;
out vec4 air;

void main()
{
    vec3 world_position = position + vec3(0.0, displacement * frame.field_depth, 0.0);
    spot = spot_at(world_position, normal);
    world_normal = normal;
    base_colour = colour;
    picture_uv = uv;
    air = air_before(world_position);
    gl_Position = frame.projection * frame.view * vec4(world_position, 1.0);
}
