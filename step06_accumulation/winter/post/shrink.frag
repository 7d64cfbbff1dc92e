#version 430 core
// A picture of fewer pixels: four lookups, each of which blends four texels.

#include "common/bindings.glsl"

layout(binding = GLOW_UNIT) uniform sampler2D larger;
uniform vec2 pixel;  // size of one of this picture's, 1: all of the picture

out vec4 colour;

void main()
{
    vec2 uv = gl_FragCoord.xy * pixel;
    vec4 sum = vec4(0.0);
    for (int corner = 0; corner < 4; ++corner) {
        vec2 side = vec2(corner & 1, corner >> 1) - 0.5;
        sum += texture(larger, uv + 0.5 * side * pixel);
    }
    colour = 0.25 * sum;
}
