#version 430 core
// Notes how far each flake is that lives: what back_to_front.comp sorts.

#include "step06_accumulation/winter/flakes/live.glsl"
#include "step06_accumulation/winter/frame.glsl"

layout(local_size_x = 128) in;

uniform uint first;  // index of the flake that this piece of the buffer begins with

layout(std430, binding = FLAKES_BUFFER) readonly buffer Flakes { Particle flakes[]; };
layout(std430, binding = DISTANCES_BUFFER) writeonly buffer Distances { float distances[]; };
layout(std430, binding = ORDER_BUFFER) writeonly buffer Order { uint order[]; };

void main()
{
    uint i = gl_GlobalInvocationID.x, index = first + i;
    if (!lives(index)) return;
    distances[index] = max(-(frame.view * vec4(flakes[i].position, 1.0)).z, 0.0);
    order[index] = index;
}
