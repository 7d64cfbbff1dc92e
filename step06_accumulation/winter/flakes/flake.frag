#version 430 core
// A snow crystal, a drop or a hailstone.

#include "step03_shader_points/habit.glsl"

uniform sampler2D crystals;

in vec2 place;
flat in vec2 tile;
flat in float width;
flat in float sharp;
flat in vec4 look;

out vec4 colour;

void main()
{
    float picture = crystal_opacity(crystals, tile, place);
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
        // Of a crystal that is a few pixels wide, or out of focus, nothing is left but a soft spot.
        float seen = smoothstep(5.0, 15.0, width) * smoothstep(0.4, 0.9, sharp);
        opacity = mix(1.0 - squared * squared, picture, seen);
    }
    colour = vec4(shade * look.rgb, clamp(look.a * opacity, 0.0, 1.0));
}
