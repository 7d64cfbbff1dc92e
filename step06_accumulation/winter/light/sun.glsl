// The disc of the sun or the moon.

#include "step06_accumulation/winter/light/light.glsl"

// Its light in this direction, length 1. It is drawn twice as wide as it is.
vec3 disc(vec3 direction)
{
    const float radius = 0.0093;  // rad; for so small an angle 1 - cos is half its square
    const float outer = 1.0 - 0.5 * 1.2 * 1.2 * radius * radius, inner = 1.0 - 0.5 * 0.8 * 0.8 * radius * radius;
    return 20.0 * smoothstep(outer, inner, dot(direction, light.to_sun)) * light.sun;
}
