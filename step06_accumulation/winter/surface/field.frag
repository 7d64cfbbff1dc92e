#version 430 core
// The field around the scene: from so far away snow is even, and nothing hides the sky.

#include "step06_accumulation/winter/light/light.glsl"
#include "step06_accumulation/winter/surface/snow_colour.glsl"

in Spot spot;
in vec3 base_colour;
in vec4 air;  // see air.glsl

out vec4 colour;

void main()
{
    const vec3 up = vec3(0.0, 1.0, 0.0);
    float cover = smoothstep(0.0, 0.02, frame.field_depth);
    vec3 light_here = frame.sky + direct_light(up, spot, sunlight_at(spot), light_within * cover);
    colour = vec4(air.rgb + air.a * mix(wet(base_colour, up, spot), snow_colour, cover) * light_here, 1.0);
}
