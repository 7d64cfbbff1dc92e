#version 430 core
// What lies behind the scene.

#include "step06_accumulation/winter/light/sky.glsl"

out vec4 colour;

void main()
{
    colour = vec4(sky_in(sight()), 1.0);
}
