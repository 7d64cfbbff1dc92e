// A surface on which no snow can lie.

#include "step05_collision/picture.glsl"
#include "step06_accumulation/winter/light/light.glsl"

in Place place;
in vec3 world_normal;
in vec3 base_colour;
in vec4 air;  // see air.glsl

// Towards the viewer, length 1.
vec3 normal_here()
{
    return normalize(gl_FrontFacing ? world_normal : -world_normal);
}

// What arrives at the eye of a surface of this colour.
vec4 as_seen(vec3 surface, vec3 normal)
{
    return vec4(air.rgb + air.a * lit(surface, normal, place, sunlight_at(place), 0.0), 1.0);
}
