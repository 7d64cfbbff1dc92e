#version 330 core
// Hands a point of the scene on to the screen.

uniform mat4 view;
uniform mat4 projection;

layout(location = 0) in vec3 position;
layout(location = 1) in vec3 normal;
layout(location = 2) in vec3 colour;
layout(location = 3) in vec2 uv;

out vec3 world_position;  // m
out vec3 world_normal;
out vec3 base_colour;
out vec2 picture_uv;

void main()
{
    world_position = position;
    world_normal = normal;
    base_colour = colour;
    picture_uv = uv;
    gl_Position = projection * view * vec4(position, 1.0);
}
