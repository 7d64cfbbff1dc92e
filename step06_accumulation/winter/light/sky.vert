#version 430 core
// A corner of the squares into which the sky is cut: it changes so slowly that between them it need not be
// computed.

#include "step06_accumulation/winter/light/sky.glsl"

uniform vec2 squares;  // across and up the window

out vec3 sight;     // world space
out vec3 radiance;  // of the sky
out float clear;    // see sky.glsl

void main()
{
    // Two triangles each: corners 0 1 2, 2 1 3.
    int square = gl_VertexID / 6, corner = gl_VertexID % 6;
    corner = corner < 3 ? corner : corner == 3 ? 2 : corner == 4 ? 1 : 3;
    int across = int(squares.x);
    ivec2 place = ivec2(square % across, square / across) + ivec2(corner & 1, corner >> 1);
    gl_Position = vec4(2.0 * vec2(place) / squares - 1.0, 1.0, 1.0);
    // In eye space.
    vec3 ahead = vec3(gl_Position.xy / vec2(camera.projection[0][0], camera.projection[1][1]), -1.0);
    sight = transpose(mat3(camera.view)) * ahead;
    vec3 direction = normalize(sight);
    radiance = sky_in(direction);
    clear = direction.y < 0.0 ? 0.0 : clear_in(direction);
}
