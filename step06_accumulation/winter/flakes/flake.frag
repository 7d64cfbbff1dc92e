#version 430 core
// A snow crystal, a drop or a hailstone.

#include "common/weather_block.glsl"

uniform sampler2D crystals;  // 4 x 4 tiles, see step 3

in vec2 place;
flat in uint crystal;
flat in float width;
flat in vec4 look;

out vec4 colour;

void main()
{
    vec2 tile = vec2(crystal & 3u, (crystal >> 2u) & 3u);
    float picture = texture(crystals, (tile + 0.5 + 0.5 * place) / 4.0).a;
    float squared = dot(place, place);  // of the distance from the middle
    float opacity = 0.0, shade = 1.0;
    if (weather.kind == rain_kind) {
        // A drop is clear: it is its rim that sends light here.
        vec2 side = place * place;
        opacity = (0.3 + side.x) * (1.0 - side.x * side.x) * (1.0 - side.y);
    } else if (weather.kind == hail_kind) {
        opacity = 1.0 - squared * squared * squared;
        shade = 0.85 + 0.15 * place.y;  // it is darker below
    } else if (squared < 1.0) {
        // Of a crystal that is a few pixels wide nothing is left but a soft spot.
        opacity = mix(1.0 - squared * squared, picture, smoothstep(5.0, 15.0, width));
    }
    colour = vec4(shade * look.rgb, clamp(look.a * opacity, 0.0, 1.0));
}
