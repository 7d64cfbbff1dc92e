#version 430 core
// The frame on the screen.

#include "step06_accumulation/winter/post/tone.glsl"

out vec4 colour;

void main()
{
    vec3 radiance = texelFetch(frame, ivec2(gl_FragCoord.xy), 0).rgb;
    colour = vec4(for_screen(radiance), 1.0);
}
