#version 430 core
// A snow crystal, a drop or a hailstone.

#include "common/bindings.glsl"
#include "step03_shader_points/habit.glsl"

layout(binding = CRYSTALS_UNIT) uniform sampler2D crystals;

in vec2 uv;
flat in vec2 tile;
flat in float width;
flat in float sharp;
flat in vec4 look;

out vec4 colour;

void main()
{
    float picture = crystal_opacity(crystals, tile, uv);
    float squared = dot(uv, uv);  // of the distance from the middle
    float opacity = 0.0, shade = 1.0;
    if (weather.kind == rain_kind) {
        // A drop is clear: it is its rim that sends light here.
        vec2 side = uv * uv;
        opacity = (0.3 + side.x) * (1.0 - side.x * side.x) * (1.0 - side.y);
    } else if (weather.kind == hail_kind) {
        opacity = 1.0 - squared * squared * squared;
        shade = 0.85 + 0.15 * uv.y;  // it is darker below
    } else if (squared < 1.0) {
        // A crystal that is a few pixels wide, or out of focus, is no more than a soft spot.
        float seen = smoothstep(5.0, 15.0, width) * smoothstep(0.4, 0.9, sharp);
        opacity = mix(1.0 - squared * squared, picture, seen);
    }
    colour = vec4(shade * look.rgb, clamp(look.a * opacity, 0.0, 1.0));
}
