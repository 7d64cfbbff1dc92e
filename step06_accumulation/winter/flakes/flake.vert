#version 430 core
// Hands a flake on to the geometry shader, as it is and in what light.

#include "common/weather_block.glsl"
#include "step05_collision/terrain.glsl"
#include "step06_accumulation/winter/light/air.glsl"

layout(location = 0) in vec3 position;  // m
layout(location = 1) in float age;      // s
layout(location = 2) in vec3 velocity;  // m/s
layout(location = 3) in float rest;     // s

uniform int around;  // 1: draw it not here but in the eight squares around, each as wide as the clouds

out Flake
{
    vec3 position;
    float age;
    vec3 velocity;
    float rest;
    uint index;
    vec3 colour;  // light that arrives at the eye
}
flake;

// The light that a white flake sends to the eye: it has no side, so light comes from everywhere. It may lie on a
// surface. The nearest cell of sky_visibility will do.
vec3 light_on_flake(vec3 position)
{
    Spot spot = spot_at(position, vec3(0.0, 1.0, 0.0));
    float seen = 0.5;
#ifdef OCCLUSION
    ivec3 cells = textureSize(sky_visibility, 0);
    ivec3 cell = ivec3(spot.in_grid * vec3(cells) + vec3(0.0, 1.0, 0.0));
    bool inside = all(greaterThanEqual(cell, ivec3(0))) && all(lessThan(cell, cells));
    if (inside) seen = 0.5 * texelFetch(sky_visibility, cell, 0).a;
#endif
    vec3 result = seen * (frame.sky + frame.ground);
    vec3 way = position - frame.eye;
    float facing = 0.5 + glow(way / max(length(way), 0.001));
    result += facing * sunlight_at(spot) * frame.sun;
#ifdef LAMP
    vec3 to_lamp = frame.lamp_position - position;
    result += 0.5 * frame.lamp / max(dot(to_lamp, to_lamp), frame.lamp_radius * frame.lamp_radius);
#endif
    return result;
}

// A colour for each number from 0 to 1: from blue by green and yellow to red.
vec3 colour_of(float t)
{
    return clamp(1.5 - abs(4.0 * clamp(t, 0.0, 1.0) - vec3(3.0, 2.0, 1.0)), 0.0, 1.0);
}

// In which a flake is drawn that is to tell something, whatever the light.
vec3 telling_colour()
{
    float terminal = terminal_speed(uint(gl_VertexID), weather);
    if (frame.colours == 1) return colour_of(length(velocity) / (2.0 * terminal));
    if (frame.colours == 2) return colour_of(age / 16.0);
    return of_first_emitter(uint(gl_VertexID), weather) ? vec3(0.1, 0.4, 1.0) : vec3(1.0, 0.5, 0.1);
}

// m from here to the instance's square: beside the clouds the air is full of flakes as well.
vec3 way_around()
{
    int square = gl_InstanceID < 4 ? gl_InstanceID : gl_InstanceID + 1;  // of 3 x 3, but the middle
    vec2 way = 2.0 * weather.emitters[0].half_size.xz * (vec2(square % 3, square / 3) - 1.0);
    vec3 there = position + vec3(way.x, 0.0, way.y);
    return vec3(way.x, terrain_at(there) - terrain_at(position), way.y);
}

void main()
{
    vec3 here = around == 1 ? position + way_around() : position;
    flake.position = here;
    flake.age = around == 1 && rest > 0.0 ? -1.0 : age;  // what lies on something does so only here
    flake.velocity = velocity;
    flake.rest = rest;
    flake.index = uint(gl_VertexID);
    vec4 air = air_before(here);
    flake.colour = frame.colours != 0 ? telling_colour() : air.rgb + air.a * light_on_flake(here);
}
