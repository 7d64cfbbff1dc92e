#version 430 core
// A surface of the scene, under as much snow as lies on it.

#include "step06_accumulation/winter/surface/look.glsl"

out vec4 colour;

void main()
{
    colour = vec4(air.rgb + air.a * light_from(look_at_surface()), 1.0);
}
