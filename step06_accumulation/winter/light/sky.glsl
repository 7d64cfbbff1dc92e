// The sky: its colour overhead, and towards the horizon more and more that of the air.

#include "step06_accumulation/winter/light/air.glsl"

// The part of the light from above the clouds that comes through the air below them.
float clear_in(vec3 direction)
{
    const float clouds = 12.0;  // m above the eye: from there the snow comes
    return exp(-light.extinction * clouds / max(direction.y, 0.012));
}

// direction: length 1, world space.
vec3 sky_in(vec3 direction)
{
    vec3 air = air_light(direction);
    if (direction.y < 0.0) return air;  // beyond the end of the field
    return mix(air, mix(light.zenith, air, exp(-6.0 * direction.y)), clear_in(direction));
}
