#version 430 core
// The frame's light as colours of the screen, and the glow that a lens makes around what is bright (BLOOM).

#include "step06_accumulation/winter/frame.glsl"

layout(binding = FRAME_UNIT) uniform sampler2D radiance;  // as HdrTarget holds it; with BLOOM, mipmapped

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

// The light of the frame, spread wider and wider: half of it over some 4 pixels, a quarter over 8, and so on.
// A level of the mipmaps is a blur by boxes; four lookups around make a tent of it.
vec3 spread_light()
{
    vec3 sum = vec3(0.0);
    for (int level = 2; level <= 6; ++level) {
        vec2 texel = exp2(float(level)) / vec2(frame.window_size);
        float weight = level < 6 ? exp2(float(1 - level)) : exp2(float(2 - level));
        for (int corner = 0; corner < 4; ++corner) {
            vec2 side = vec2(corner & 1, corner >> 1) - 0.5;
            vec2 uv = gl_FragCoord.xy / vec2(frame.window_size) + side * texel;
            sum += 0.25 * weight * textureLod(radiance, uv, float(level)).rgb;
        }
    }
    return sum;
}

void main()
{
    vec3 light = texelFetch(radiance, ivec2(gl_FragCoord.xy), 0).rgb;
#ifdef BLOOM
    light = mix(light, spread_light(), frame.bloom);
#endif
    colour = vec4(for_screen(light), 1.0);
}
