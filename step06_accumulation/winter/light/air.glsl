// What the air makes of the light on its way to the eye.

#include "step06_accumulation/winter/light/light.glsl"

// How the sun makes snow in the air shine that is seen in this direction (length 1): it scatters most light
// forwards, so it glows around the sun (phase function, times pi: Henyey and Greenstein, "Diffuse radiation
// in the Galaxy", 1941).
float glow(vec3 direction)
{
    const float forwards = 0.7;  // mean cosine of the angle of scattering
    float squared = 1.0 + forwards * forwards - 2.0 * forwards * dot(direction, frame.to_sun);
    return (1.0 - forwards * forwards) / (4.0 * squared * sqrt(squared));
}

// Colour of so much air that nothing shines through it, seen in this direction (length 1).
vec3 air_light(vec3 direction)
{
    const float sunlit = 0.25;  // fraction of the air that the sun reaches
    float sunset = max(dot(direction.xz, normalize(frame.to_sun.xz)), 0.0);
    return frame.horizon + sunset * sunset * frame.twilight + sunlit * glow(direction) * frame.sun;
}

// What arrives at the eye of the radiance L that leaves this point is rgb + a * L: the air adds its own light,
// and takes some of the other.
vec4 air_before(vec3 position)
{
    vec3 way = position - frame.eye;
    float away = length(way);
    // No way has no direction, either.
    if (frame.extinction == 0.0 || away < 0.001) return vec4(0.0, 0.0, 0.0, 1.0);
    float clear = exp(-frame.extinction * away);
    return vec4((1.0 - clear) * air_light(way / away), clear);
}
