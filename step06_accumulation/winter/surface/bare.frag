#version 430 core
// A surface on which no snow can lie.

#include "step06_accumulation/winter/surface/bare.glsl"

out vec4 colour;

void main()
{
    colour = as_seen(with_picture(base_colour), normal_here());
}
