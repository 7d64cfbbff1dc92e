#version 430 core
// A surface of the scene, under as much snow as lies on it.

#include "step06_accumulation/light.glsl"
#include "step06_accumulation/snow_cover.glsl"

in vec3 world_position;
in vec3 world_normal;
in vec3 base_colour;
in vec3 snow_normal;
in float snow_depth;

out vec4 colour;

// How much of the surface is hidden by snow, 0 to 1.
float snow_cover()
{
    const float covering_depth = 0.02;  // m, from which on nothing shines through
    if (world_normal.y > 0.1) return smoothstep(0.0, covering_depth, snow_depth);
    // The side of something: its upper edge was lifted, so it is snow as far as snow reaches down.
    vec3 place = (world_position - grid_origin) / cell_size;
    float filled = float(mass_in(ivec3(floor(place)))) / float(full_cell);
    return snow_depth > 0.0 && fract(place.y) < filled ? 1.0 : 0.0;
}

void main()
{
    const vec3 snow_colour = vec3(0.90, 0.93, 0.97);
    float cover = snow_cover();
    vec3 surface_normal = normalize(mix(normalize(world_normal), normalize(snow_normal), cover));
    vec3 radiance = lit(mix(base_colour, snow_colour, cover), surface_normal, world_position);
    colour = vec4(tone_mapped(through_air(radiance, world_position)), 1.0);
}
