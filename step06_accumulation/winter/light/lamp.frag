#version 430 core
// The glass of a lamp that is on: it shines, whatever falls on it.

#include "step06_accumulation/winter/light/light.glsl"

uniform vec3 own_light;

in vec3 world_position;

out vec4 colour;

void main()
{
    const float brightness = 12.0;
    vec3 radiance = brightness * light.lamp_is_on * own_light;
    colour = vec4(tone_mapped(through_air(radiance, world_position)), 1.0);
}
