#version 330 core
// A snow crystal: one of the sixteen pictures of the atlas, chosen and turned by the flake's index.

#include "common/snow.glsl"

uniform sampler2D crystals;  // 4 x 4 tiles

flat in uint index;
in float coverage;
out vec4 colour;

void main()
{
    uint bits = hash(index);
    float angle = float(bits >> 8u) * (6.2831853 / 16777216.0);
    mat2 turn = mat2(cos(angle), sin(angle), -sin(angle), cos(angle));
    vec2 place = turn * (2.0 * gl_PointCoord - 1.0);  // -1 to 1 across the sprite
    vec2 tile = vec2(bits & 3u, (bits >> 2u) & 3u);
    // Before any pixel is discarded: the mipmap level follows from the neighbours' places in the picture.
    float opacity = texture(crystals, (tile + 0.5 + 0.5 * place) / 4.0).a;
    if (dot(place, place) > 1.0) discard;
    colour = vec4(vec3(1.0), coverage * opacity);
}
