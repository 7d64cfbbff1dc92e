#version 430 core
// As bare.frag, in the wind: on its weather side snow clings to what is rough.

#include "common/weather_block.glsl"
#include "step06_accumulation/winter/surface/bare.glsl"
#include "step06_accumulation/winter/surface/snow_colour.glsl"

uniform sampler2D grain;   // see grain.hpp
uniform float grain_size;  // m, after which it repeats

out vec4 colour;

// How much of the wall is hidden, 0 to 1: the more it snows on it, which the wind does where it meets the wall
// and where nothing is before that, which is where the sky is seen.
float dust(vec3 normal)
{
    const float strong = 4.0;     // m/s
    const float much = 0.1;       // m of snow on open ground
    const float most = 0.45;      // hidden
    float against = -dot(normal, weather.wind) / strong;
    // 1: half of the sky is open.
    float open = min(4.0 * sky_seen_from(place, normal).w, 1.0);
    float amount = most * clamp(against, 0.0, 1.0) * open * open *
                   smoothstep(0.0, much, camera.field_depth);
    vec2 along = vec2(place.world.x + place.world.z, place.world.y) / grain_size;
    return smoothstep(-0.15, 0.15, amount - texture(grain, along).b) * step(0.001, amount);
}

void main()
{
    vec3 normal = normal_here();
    colour = as_seen(mix(with_picture(base_colour), snow_colour, dust(normal)), normal);
}
