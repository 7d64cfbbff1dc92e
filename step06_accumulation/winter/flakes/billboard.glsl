// Makes of a flake, a point, what an open shutter sees of it: a rectangle along its way across the window.

#include "step03_shader_points/habit.glsl"
#include "step06_accumulation/winter/frame.glsl"

layout(points) in;
layout(triangle_strip) out;

in Flake
{
    vec3 position;
    float age;
    vec3 velocity;
    float rest;
    uint index;
    vec3 colour;
}
flake[];

out vec2 uv;            // -1 to 1 across the flake: turned with the crystal, or with its way
flat out vec2 tile;     // its picture in the atlas
flat out float width;   // pixels
flat out float sharp;   // 1: in focus
flat out vec4 look;     // its colour, and its opacity

// In pixels from the middle of the window.
vec2 pixel_of(vec4 clip)
{
    return 0.5 * vec2(frame.window_size) * clip.xy / clip.w;
}

// Width of the spot, in pixels, that a camera focused on the distance makes of a point that far away, m: a
// lens `aperture` wide, seen at infinity, has moved by that much on what is in focus.
float out_of_focus(float away)
{
    const float aperture = 0.012, in_focus = 5.0;  // m
    float pixels_per_radian = 0.5 * float(frame.window_size.y) * frame.projection[1][1];
#ifdef BLUR
    return aperture * pixels_per_radian * max(1.0 / away - 1.0 / in_focus, 0.0);
#else
    return 0.0;
#endif
}

// Draws something round where it was seen for the last `exposure` s: as wide as it is, and longer by its way
// relative to the camera's. The longer the fainter, so that it sends the same light to the eye whether the
// frame was short or long; and so is what is out of focus. opacity: of what is at rest. turn: of the crystal.
void draw(vec3 position, vec3 velocity, float exposure, float diameter, float opacity, mat2 turn)
{
    const float least_width = 2.0;               // pixels; see sprite.glsl of step 3
    const float nearest = 0.3, all_there = 1.5;  // m: what is nearer would fill the window, so it fades
    vec4 here = frame.view * vec4(position, 1.0);
    vec4 now = frame.projection * here;
    vec4 before = frame.projection * frame.view_before * vec4(position - exposure * velocity, 1.0);
    if (now.w < nearest || any(greaterThan(abs(now.xy), vec2(1.2 * now.w)))) return;  // out of sight
    vec2 way = before.w < nearest ? vec2(0.0) : pixel_of(now) - pixel_of(before);
    vec2 along = length(way) < 0.01 ? vec2(0.0, 1.0) : normalize(way);
    vec2 across = vec2(along.y, -along.x);
    float length_of_way = min(length(way), 0.15 * float(frame.window_size.y));  // the camera may have jumped

    // projection[1][1] is 1 / tan(half the field of view), now.w the distance along the view.
    float pixels = 0.5 * float(frame.window_size.y) * frame.projection[1][1] * diameter / now.w;
    float drawn = max(pixels + out_of_focus(now.w), least_width);
    float covered = pixels / drawn * pixels / (drawn + length_of_way);  // fraction of the rectangle
    opacity *= covered * smoothstep(nearest, all_there, now.w);
    // As deep as its nearest point, or the ground would cut off its lower half.
    vec4 front = frame.projection * (here + vec4(0.0, 0.0, min(diameter, 0.5 * now.w), 0.0));
    for (int corner = 0; corner < 4; ++corner) {
        vec2 side = 2.0 * vec2(corner & 1, corner >> 1) - 1.0;
        vec2 pixel = pixel_of(now) - 0.5 * length_of_way * along + 0.5 * drawn * side.x * across +
                     0.5 * (drawn + length_of_way) * side.y * along;
        uv = weather.kind == rain_kind ? side : turn * (side.x * across + side.y * along);
        tile = crystal_tile(flake[0].index);
        width = drawn;
        sharp = pixels / drawn;
        look = vec4(flake[0].colour, opacity);
        gl_Position = now.w * vec4(2.0 * pixel / vec2(frame.window_size), front.z / front.w, 1.0);
        EmitVertex();
    }
    EndPrimitive();
}
