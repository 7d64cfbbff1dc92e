#version 330 core
// Places a flake that carries its own index, as gl_VertexID only counts those that live.

#include "step03_shader_points/sprite.glsl"

layout(location = 0) in vec3 position;  // m
layout(location = 3) in float rest;     // s
layout(location = 4) in uint flake;

void main()
{
    draw_sprite(flake, position, rest);
}
