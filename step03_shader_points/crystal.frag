#version 330 core
// A snow crystal: one of the pictures of the atlas, turned by the flake's index.

#include "step03_shader_points/habit.glsl"

uniform sampler2D crystals;

flat in uint index;
in float coverage;
out vec4 colour;

void main()
{
    float angle = float(hash(index) >> 8u) * (6.2831853 / 16777216.0);
    mat2 turn = mat2(cos(angle), sin(angle), -sin(angle), cos(angle));
    vec2 uv = turn * (2.0 * gl_PointCoord - 1.0);  // -1 to 1 across the sprite
    // Before any pixel is discarded: the mipmap level follows from the uv of its neighbours.
    float opacity = crystal_opacity(crystals, crystal_tile(index), uv);
    if (dot(uv, uv) > 1.0) discard;
    // The picture of a crystal that is a few pixels wide is a faint blur: it is drawn as a soft disc.
    float pixels = 1.0 / fwidth(gl_PointCoord.x);  // across the sprite
    opacity = mix(1.0 - dot(uv, uv), opacity, smoothstep(2.0, 10.0, pixels));
    colour = vec4(vec3(1.0), coverage * opacity);
}
