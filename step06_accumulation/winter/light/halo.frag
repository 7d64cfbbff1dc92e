#version 430 core
// The halo that snow in the air makes around a lamp that is on, added to the frame.

#include "step06_accumulation/winter/light/air.glsl"

uniform sampler2D frame_depth;

out vec4 colour;

// Where in the world this pixel's surface is, m.
vec3 surface_at(vec2 place)  // clip space
{
    float depth = 2.0 * texelFetch(frame_depth, ivec2(gl_FragCoord.xy), 0).r - 1.0;
    // projection[2][2] and [3][2] make of the distance along the view, w, the depth (-[2][2] w + [3][2]) / w.
    float away = camera.projection[3][2] / (depth + camera.projection[2][2]);
    // In eye space.
    vec3 sight = away * vec3(place / vec2(camera.projection[0][0], camera.projection[1][1]), -1.0);
    return camera.eye + transpose(mat3(camera.view)) * sight;
}

// Light that the air between the eye and this point sends here from the lamp. Every metre scatters
// extinction / 4 pi of what reaches it to any side; the sum over 1 / distance^2 to the lamp along a line is
// the angle under which the lamp sees that line over its distance from the line.
vec3 lamp_halo(vec3 position)
{
    vec3 from = camera.eye - light.lamp_position, to = position - light.lamp_position;
    float lengths = max(length(from) * length(to), 1e-6);  // the eye, or the point, may be in the lamp
    float angle = acos(clamp(dot(from, to) / lengths, -1.0, 1.0));
    float closest = max(length(cross(from, to)) / distance(camera.eye, position), light.lamp_radius);
    float left = exp(-light.extinction * length(from));  // and on its way here it loses some
    return 0.25 * light.extinction * left * angle / closest * light.lamp;
}

void main()
{
    vec2 place = 2.0 * gl_FragCoord.xy / vec2(camera.window_size) - 1.0;
    colour = vec4(lamp_halo(surface_at(place)), 1.0);
}
