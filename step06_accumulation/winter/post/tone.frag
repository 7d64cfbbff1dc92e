#version 430 core
// The frame's light as colours of the screen, and around what is bright its glow (BLOOM).

#include "step06_accumulation/winter/frame.glsl"

layout(binding = FRAME_UNIT) uniform sampler2D radiance;  // as HdrTarget holds it
layout(binding = GLOW_UNIT) uniform sampler2D glow;       // the same, spread out

out vec4 colour;

// The numbers, 0 to 1, that the screen is told for such light. They never get to 1, so however bright, snow
// keeps its shades. An eye answers to light x times as strong as what it answers to by half, here 0.65, by
// x^n / (1 + x^n), here with n = 1.25 (Naka and Rushton 1966; for pictures: Reinhard and Devlin, "Dynamic range
// reduction inspired by photoreceptor physiology", 2005). A screen that is to shine so brightly is told that
// by the curve of sRGB (IEC 61966-2-1). Powers would cost more than all the rest: this is a fit to both
// together, with one square root, off by no more than 3.3 of 255.
vec3 for_screen(vec3 light)
{
    vec3 x = 3.5 * frame.exposure * max(light, 0.0), root = sqrt(x);
    return (0.18 * root + x) / (1.0 + 0.1 * root + x);
}

void main()
{
    vec3 light = texelFetch(radiance, ivec2(gl_FragCoord.xy), 0).rgb;
#ifdef BLOOM
    light = mix(light, texture(glow, gl_FragCoord.xy / vec2(frame.window_size)).rgb, frame.bloom);
#endif
    colour = vec4(for_screen(light), 1.0);
}
