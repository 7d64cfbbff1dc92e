#version 430 core
// A surface on which no snow can lie. In the wind snow clings to what is rough of its weather side (DUSTING).

#include "common/weather_block.glsl"
#include "step05_collision/picture.glsl"
#include "step06_accumulation/winter/light/light.glsl"
#include "step06_accumulation/winter/surface/snow_colour.glsl"

layout(binding = GRAIN_UNIT) uniform sampler2D grain;  // see grain.hpp

in Spot spot;
in vec3 world_normal;
in vec3 base_colour;
in vec4 air;  // see air.glsl

out vec4 colour;

uniform vec3 own_light;  // what the surface shines by itself when the lamp is on

// How much of the wall is hidden, 0 to 1: the more it snows on it, which the wind does where it meets the wall
// and where nothing is before that, which is where the sky is seen.
float dust(vec3 normal)
{
#ifdef DUSTING
    const float strong = 4.0;     // m/s
    const float much = 0.1;       // m of snow on open ground
    const float most = 0.45;      // hidden
    float against = -dot(normal, weather.wind) / strong;
    // 1: half of the sky is open.
    float open = min(4.0 * sky_seen_from(spot, normal).w, 1.0);
    float amount = most * clamp(against, 0.0, 1.0) * open * open * smoothstep(0.0, much, frame.field_depth);
    vec2 along = vec2(spot.position.x + spot.position.z, spot.position.y) / grain_size;
    return smoothstep(-0.15, 0.15, amount - texture(grain, along).b) * step(0.001, amount);
#else
    return 0.0;
#endif
}

void main()
{
    vec3 normal = normalize(gl_FrontFacing ? world_normal : -world_normal);  // towards the viewer
    vec3 surface = mix(wet(with_picture(base_colour), normal, spot), snow_colour, dust(normal));
    vec3 radiance = lit(surface, normal, spot, sunlight_at(spot), 0.0) + frame.lamp_is_on * own_light;
    colour = vec4(air.rgb + air.a * radiance, 1.0);
}
