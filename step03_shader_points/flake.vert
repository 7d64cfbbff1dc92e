#version 330 core
// Places a flake on the screen and makes its sprite as many pixels wide as the flake looks from here.

#include "step03_shader_points/sprite.glsl"

layout(location = 0) in vec3 position;  // m
layout(location = 3) in float rest;     // s

void main()
{
    draw_sprite(uint(gl_VertexID), position, rest);
}
