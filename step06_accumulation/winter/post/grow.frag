#version 430 core
// Adds to a picture (blending does) a smaller one, smoothly: nine texels around, by four lookups.

#include "common/bindings.glsl"

layout(binding = GLOW_UNIT) uniform sampler2D smaller;
uniform vec2 pixel;  // size of one of this picture's, 1: all of the picture

out vec4 colour;

void main()
{
    vec2 uv = gl_FragCoord.xy * pixel;
    vec4 sum = vec4(0.0);
    for (int corner = 0; corner < 4; ++corner) {
        vec2 side = 2.0 * vec2(corner & 1, corner >> 1) - 1.0;
        sum += texture(smaller, uv + side * pixel);
    }
    colour = vec4(0.25 * sum.rgb, 0.5);
}
