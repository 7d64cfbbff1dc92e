#version 430 core
// Notes how far each flake is, and fills up with nothing to a power of two: what back_to_front.comp sorts.

#include "common/weather_block.glsl"
#include "step06_accumulation/winter/camera/camera.glsl"

layout(local_size_x = 1024) in;

uniform uint first, count;  // flakes; count 0: there are none, only places to fill up
uniform uint place;         // of the first one in the order
uniform uint places;        // to write

layout(std430, binding = FLAKES_BUFFER) readonly buffer Flakes { Particle flakes[]; };
layout(std430, binding = DISTANCES_BUFFER) writeonly buffer Distances { float distances[]; };
layout(std430, binding = ORDER_BUFFER) writeonly buffer Order { uint order[]; };

void main()
{
    uint i = gl_GlobalInvocationID.x;
    if (i >= places) return;  // the last group may reach beyond them
    uint flake = first + i;
    distances[place + i] = i < count ? max(-(camera.view * vec4(flakes[flake].position, 1.0)).z, 0.0) : -1.0;
    order[place + i] = i < count ? flake : 0u;
}
