#version 430 core
// A flake, a drop or a hailstone in the air, or as it lies and melts.

#include "step06_accumulation/winter/flakes/billboard.glsl"

layout(max_vertices = 4) out;

void main()
{
    vec3 position = flake[0].position;
    float age = flake[0].age, rest = flake[0].rest;
    uint index = flake[0].index;
    float size = diameter(index, weather);
    if (age < 0.0) return;  // it waits to be born

    if (weather.kind == rain_kind) {
        if (rest > 0.0) return;  // see splash.geom
        // The eye is slow: it never sees drops, but how they sparkle on their way.
        draw(position, flake[0].velocity, min(max(frame.shutter, 1.0 / 30.0), age), size, 6.0, mat2(1.0));
    } else {
        float left = 1.0 - clamp(rest / max(weather.melt_time, weather.time_step), 0.0, 1.0);
        // A crystal turns slowly, one way or the other, and tumbles: what is tilted looks narrower.
        vec2 random = vec2(hash(index) >> 8u, hash(index + 1u) >> 8u) / 16777216.0;
        float angle = 6.2831853 * random.x + (3.0 * random.y - 1.5) * (age - rest);
        mat2 turn = mat2(1.0, 0.0, 0.0, 1.3 + 0.3 * sin(angle)) *
                    mat2(cos(angle), sin(angle), -sin(angle), cos(angle));
        if (weather.kind == hail_kind) turn = mat2(1.0);
        size *= mix(0.4, 1.0, left);  // what melts shrinks
        draw(position, flake[0].velocity, min(frame.shutter, age), size, left, turn);
    }
}
