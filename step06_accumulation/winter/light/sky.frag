#version 430 core
// What lies behind the scene: the sky, and in it the disc of the sun or the moon.

#include "step06_accumulation/winter/frame.glsl"

in vec3 sight;
in vec3 radiance;
in float clear;

out vec4 colour;

// Light of the disc in this direction, length 1. It is drawn twice as wide as it is.
vec3 disc(vec3 direction)
{
    const float radius = 0.0093;  // rad; for so small an angle 1 - cos is half its square
    const float outer = 1.0 - 0.5 * 1.2 * 1.2 * radius * radius;
    const float inner = 1.0 - 0.5 * 0.8 * 0.8 * radius * radius;
    return 20.0 * smoothstep(outer, inner, dot(direction, frame.to_sun)) * frame.sun;
}

void main()
{
    colour = vec4(radiance + clear * disc(normalize(sight)), 1.0);
}
