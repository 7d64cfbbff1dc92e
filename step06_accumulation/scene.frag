#version 430 core
// A surface of the scene, under as much snow as lies on it.

#include "step05_collision/light.glsl"

in vec3 world_position;
in vec3 world_normal;
in vec3 base_colour;
in float snow_depth;

out vec4 colour;

void main()
{
    const vec3 snow_colour = vec3(0.90, 0.93, 0.97);
    const float covering_depth = 0.02;  // m, from which on nothing shines through
    float cover = smoothstep(0.0, covering_depth, snow_depth);
    // The snow's own surface: what lies one pixel to the right and one pixel up spans it.
    vec3 snow_normal = normalize(cross(dFdx(world_position), dFdy(world_position)));
    vec3 surface_normal = normalize(mix(normalize(world_normal), snow_normal, cover));
    colour = vec4(lit(mix(base_colour, snow_colour, cover), surface_normal, world_position), 1.0);
}
