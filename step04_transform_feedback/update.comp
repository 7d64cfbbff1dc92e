#version 430 core
// One time step of one flake, as update.vert makes it, but in place: an invocation that may write anywhere in
// the buffer reads and writes the one flake that is its own, and needs no second buffer.

#include "common/bindings.glsl"
#include "common/weather_block.glsl"

// The largest group that every card takes. Every card also takes 65,535 of them, enough for the largest pool.
layout(local_size_x = 1024) in;

uniform uint tick;  // number of the time step

// std430 lays a Particle out as C++ does: each of its vec3 is followed by one float.
layout(std430, binding = FLAKES_BUFFER) buffer Flakes { Particle flakes[]; };

void main()
{
    uint index = gl_GlobalInvocationID.x;
    if (index >= weather.particles) return;  // the last group may reach beyond the pool
    flakes[index] = advance(flakes[index], index, tick, weather);
}
