#version 430 core
// A corner of a patch: it waits for the vertices that tessellation adds before anything is lifted.

layout(location = 0) in vec3 position;
layout(location = 1) in vec3 normal;
layout(location = 2) in vec3 colour;
layout(location = 3) in vec2 uv;
layout(location = 4) in float lift;
layout(location = 5) in float skirt;
layout(location = 6) in vec4 even;

out Corner { vec3 position, normal, colour; vec2 uv; float lift, skirt; vec4 even; } corner;

void main()
{
    corner.position = position;
    corner.normal = normal;
    corner.colour = colour;
    corner.uv = uv;
    corner.lift = lift;
    corner.skirt = skirt;
    corner.even = even;
}
