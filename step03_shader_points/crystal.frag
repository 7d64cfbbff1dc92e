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
    vec2 place = turn * (2.0 * gl_PointCoord - 1.0);  // -1 to 1 across the sprite
    // Before any pixel is discarded: the mipmap level follows from the neighbours' places in the picture.
    float opacity = crystal_opacity(crystals, crystal_tile(index), place);
    if (dot(place, place) > 1.0) discard;
    colour = vec4(vec3(1.0), coverage * opacity);
}
