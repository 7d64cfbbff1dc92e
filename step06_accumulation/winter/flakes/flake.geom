#version 430 core
// Makes of a flake, a point, what an open shutter sees of it: a rectangle along its way across the window. A
// drop that has come down becomes a splash.

#include "step03_shader_points/habit.glsl"
#include "step06_accumulation/winter/camera/camera.glsl"

layout(points) in;
layout(triangle_strip, max_vertices = 16) out;

uniform bool splashes;

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

out vec2 place;         // -1 to 1 across the flake: turned with the crystal, or with its way
flat out vec2 tile;     // its picture in the atlas
flat out float width;   // pixels
flat out vec4 look;     // its colour, and its opacity

// In pixels from the middle of the window.
vec2 pixel_of(vec4 clip_place)
{
    return 0.5 * vec2(camera.window_size) * clip_place.xy / clip_place.w;
}

// Draws something round where it was seen for the last `exposure` s: as wide as it is, and longer by its way
// relative to the camera's. The longer the fainter, so that it sends the same light to the eye whether the
// frame was short or long. opacity: of what is at rest. turn: of the crystal.
void draw(vec3 position, vec3 velocity, float exposure, float diameter, float opacity, mat2 turn)
{
    const float least_width = 2.0;               // pixels; see sprite.glsl of step 3
    const float nearest = 0.3, all_there = 1.5;  // m: what is nearer would fill the window, so it fades
    vec4 here = camera.view * vec4(position, 1.0);
    vec4 now = camera.projection * here;
    vec4 before = camera.projection * camera.view_before * vec4(position - exposure * velocity, 1.0);
    if (now.w < nearest) return;
    vec2 way = before.w < nearest ? vec2(0.0) : pixel_of(now) - pixel_of(before);
    vec2 along = length(way) < 0.01 ? vec2(0.0, 1.0) : normalize(way);
    vec2 across = vec2(along.y, -along.x);
    float length_of_way = min(length(way), 0.15 * float(camera.window_size.y));  // the camera may have jumped

    // projection[1][1] is 1 / tan(half the field of view), now.w the distance along the view.
    float pixels = 0.5 * float(camera.window_size.y) * camera.projection[1][1] * diameter / now.w;
    float drawn = max(pixels, least_width);
    float part = pixels / drawn * pixels / (drawn + length_of_way);  // of the rectangle that it covers
    opacity *= part * smoothstep(nearest, all_there, now.w);
    // As deep as its nearest point, or the ground would cut off its lower half.
    vec4 front = camera.projection * (here + vec4(0.0, 0.0, min(diameter, 0.5 * now.w), 0.0));
    for (int corner = 0; corner < 4; ++corner) {
        vec2 side = 2.0 * vec2(corner & 1, corner >> 1) - 1.0;
        vec2 pixel = pixel_of(now) - 0.5 * length_of_way * along + 0.5 * drawn * side.x * across +
                     0.5 * (drawn + length_of_way) * side.y * along;
        place = weather.kind == rain_kind ? side : turn * (side.x * across + side.y * along);
        tile = crystal_tile(flake[0].index);
        width = drawn;
        look = vec4(flake[0].colour, opacity);
        gl_Position = now.w * vec4(2.0 * pixel / vec2(camera.window_size), front.z / front.w, 1.0);
        EmitVertex();
    }
    EndPrimitive();
}

// Droplets that a drop has thrown up where it came down, `time` s ago. They fly as stones do, without drag.
void draw_splash(vec3 position, float time, float diameter, uint index)
{
    for (uint droplet = 0u; droplet < 4u; ++droplet) {
        uint bits = hash(4u * index + droplet);
        vec3 random = vec3(bits & 255u, (bits >> 8u) & 255u, (bits >> 16u) & 255u) / 255.0;
        float angle = 6.2831853 * (float(droplet) + random.x) / 4.0;
        float speed = 0.2 + 0.4 * random.y;  // m/s, along the ground
        vec3 start = vec3(speed * cos(angle), 0.6 + 0.6 * random.z, speed * sin(angle));
        vec3 way = start * time + 0.5 * weather.gravity * time * time;
        if (way.y < 0.0) continue;  // down again
        vec3 velocity = start + weather.gravity * time;
        draw(position + way, velocity, min(camera.shutter, time), diameter, 2.0, mat2(1.0));
    }
}

void main()
{
    vec3 position = flake[0].position;
    float age = flake[0].age, rest = flake[0].rest;
    uint index = flake[0].index;
    float size = diameter(index, weather);
    if (age < 0.0) return;  // it waits to be born

    if (weather.kind == rain_kind && rest > 0.0) {
        if (splashes) draw_splash(position, rest, 0.8 * size, index);
    } else if (weather.kind == rain_kind) {
        // The eye is slow: it never sees drops, but how they sparkle on their way.
        draw(position, flake[0].velocity, min(max(camera.shutter, 1.0 / 30.0), age), size, 6.0, mat2(1.0));
    } else {
        float left = 1.0 - clamp(rest / max(weather.melt_time, weather.time_step), 0.0, 1.0);
        // A crystal turns slowly, one way or the other, and tumbles: what is tilted looks narrower.
        vec2 random = vec2(hash(index) >> 8u, hash(index + 1u) >> 8u) / 16777216.0;
        float angle = 6.2831853 * random.x + (3.0 * random.y - 1.5) * (age - rest);
        mat2 turn = mat2(1.0, 0.0, 0.0, 1.3 + 0.3 * sin(angle)) *
                    mat2(cos(angle), sin(angle), -sin(angle), cos(angle));
        if (weather.kind == hail_kind) turn = mat2(1.0);
        draw(position, flake[0].velocity, min(camera.shutter, age), size, left, turn);
    }
}
