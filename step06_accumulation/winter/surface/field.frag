#version 430 core
// The field around the scene: from so far away snow is even, and nothing hides the sky.

#include "step06_accumulation/winter/light/light.glsl"
#include "step06_accumulation/winter/surface/snow_colour.glsl"

uniform vec3 ground_colour;

in Place place;
in vec4 air;  // see air.glsl

out vec4 colour;

void main()
{
    const vec3 up = vec3(0.0, 1.0, 0.0);
    float cover = smoothstep(0.0, 0.02, camera.field_depth);
    vec3 light_here = light.sky + direct_light(up, place, sunlight_at(place), light_within * cover);
    colour = vec4(air.rgb + air.a * mix(ground_colour, snow_colour, cover) * light_here, 1.0);
}
