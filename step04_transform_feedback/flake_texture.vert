#version 330 core
// Places flake gl_VertexID, whose state is a pixel of two textures instead of a record in a buffer.

#include "step03_shader_points/sprite.glsl"

uniform sampler2D position_age;
uniform sampler2D velocity_rest;

void main()
{
    int width = textureSize(position_age, 0).x;
    ivec2 pixel = ivec2(gl_VertexID % width, gl_VertexID / width);
    draw_sprite(uint(gl_VertexID), texelFetch(position_age, pixel, 0).xyz,
                texelFetch(velocity_rest, pixel, 0).w);
}
