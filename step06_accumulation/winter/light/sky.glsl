// The sky: its colour overhead, and towards the horizon more and more that of the air.

#include "step06_accumulation/winter/light/air.glsl"

// Where this pixel looks, length 1, world space.
vec3 sight()
{
    vec2 place = 2.0 * gl_FragCoord.xy / vec2(camera.window_size) - 1.0;  // clip space
    vec3 ahead = vec3(place / vec2(camera.projection[0][0], camera.projection[1][1]), -1.0);  // eye space
    return normalize(transpose(mat3(camera.view)) * ahead);
}

// The part of the light from above the clouds that comes through the air below them.
float clear_in(vec3 direction)
{
    const float clouds = 12.0;  // m above the eye: from there the snow comes
    return exp(-light.extinction * clouds / max(direction.y, 0.012));
}

// The disc of the sun or the moon, drawn twice as wide as it is.
float disc(vec3 direction)
{
    const float radius = 0.0093;  // rad; for so small an angle 1 - cos is half its square
    const float outer = 1.0 - 0.5 * 1.2 * 1.2 * radius * radius, inner = 1.0 - 0.5 * 0.8 * 0.8 * radius * radius;
    return smoothstep(outer, inner, dot(direction, light.to_sun));
}

vec3 sky_in(vec3 direction)
{
    vec3 air = air_light(direction);
    if (direction.y < 0.0) return air;  // beyond the end of the field
    vec3 above = mix(light.zenith, air, exp(-6.0 * direction.y)) + 20.0 * disc(direction) * light.sun;
    return mix(air, above, clear_in(direction));
}
