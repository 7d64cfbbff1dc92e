#version 430 core
// A corner of the squares into which the sky is cut: it changes so slowly that between them it need not be
// computed. Towards the horizon its colour is more and more that of the air.

#include "step06_accumulation/winter/light/air.glsl"

out vec3 sight;     // world space
out vec3 radiance;  // of the sky
out float clear;    // the fraction of the light from above the clouds that comes through the air below them

void main()
{
    // Two triangles each: corners 0 1 2, 2 1 3.
    const ivec2 squares = ivec2(40, 24);  // across and up the window, as in winter.cpp
    int square = gl_VertexID / 6, corner = gl_VertexID % 6;
    corner = corner < 3 ? corner : corner == 3 ? 2 : corner == 4 ? 1 : 3;
    ivec2 knot = ivec2(square % squares.x, square / squares.x) + ivec2(corner & 1, corner >> 1);
    gl_Position = vec4(2.0 * vec2(knot) / vec2(squares) - 1.0, 1.0, 1.0);
    // In eye space.
    vec3 ahead = vec3(gl_Position.xy / vec2(frame.projection[0][0], frame.projection[1][1]), -1.0);
    sight = transpose(mat3(frame.view)) * ahead;
    vec3 direction = normalize(sight);
    radiance = air_light(direction);
    clear = 0.0;
    if (direction.y < 0.0) return;  // beyond the end of the field
    const float clouds = 12.0;  // m above the eye: from there the snow comes
    clear = exp(-frame.extinction * clouds / max(direction.y, 0.012));
    radiance = mix(radiance, mix(frame.zenith, radiance, exp(-6.0 * direction.y)), clear);
}
