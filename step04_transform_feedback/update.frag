#version 330 core
// One time step of one flake as a pixel: two textures hold the old state, two receive the new one.

#include "common/weather_block.glsl"

uniform uint tick;                // number of the time step
uniform sampler2D position_age;   // xyz position, w age
uniform sampler2D velocity_rest;  // xyz velocity, w rest

layout(location = 0) out vec4 new_position_age;
layout(location = 1) out vec4 new_velocity_rest;

void main()
{
    ivec2 pixel = ivec2(gl_FragCoord.xy);
    uint index = uint(pixel.y * textureSize(position_age, 0).x + pixel.x);
    vec4 first = texelFetch(position_age, pixel, 0), second = texelFetch(velocity_rest, pixel, 0);
    Particle p = advance(Particle(first.xyz, first.w, second.xyz, second.w), index, tick, weather);
    new_position_age = vec4(p.position, p.age);
    new_velocity_rest = vec4(p.velocity, p.rest);
}
