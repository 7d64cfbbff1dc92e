#version 430 core
// The frame on the screen, and around what is bright its glow.

#include "step06_accumulation/winter/post/tone.glsl"

uniform sampler2D glow;  // the frame's light, spread out
uniform float part;      // of all light that is spread

out vec4 colour;

void main()
{
    ivec2 pixel = ivec2(gl_FragCoord.xy);
    vec3 radiance = texelFetch(frame, pixel, 0).rgb;
    vec3 spread = texture(glow, gl_FragCoord.xy / vec2(textureSize(frame, 0))).rgb;
    colour = vec4(for_screen(mix(radiance, spread, part)), 1.0);
}
