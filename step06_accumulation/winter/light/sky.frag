#version 430 core
// What lies behind the scene.

#include "step06_accumulation/winter/light/sun.glsl"

in vec3 sight;
in vec3 radiance;
in float clear;

out vec4 colour;

void main()
{
    colour = vec4(radiance + clear * disc(normalize(sight)), 1.0);
}
