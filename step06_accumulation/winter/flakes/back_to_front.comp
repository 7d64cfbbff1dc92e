#version 430 core
// One pass of a bitonic sort (Batcher, "Sorting networks and their applications", 1968): each invocation
// compares two places, `apart` from each other, and puts the farther flake first, or second, so that in the end
// runs of `run` places fall and rise in turn, and with the last pass all fall.

#include "common/bindings.glsl"

layout(local_size_x = 1024) in;

uniform uint run, apart;  // powers of two

layout(std430, binding = DISTANCES_BUFFER) buffer Distances { float distances[]; };
layout(std430, binding = ORDER_BUFFER) buffer Order { uint order[]; };

void main()
{
    uint i = gl_GlobalInvocationID.x;
    uint a = 2u * i - (i & (apart - 1u)), b = a + apart;  // no two invocations have an element in common
    if (b >= uint(distances.length())) return;
    bool falls = (a & run) == 0u;
    float first = distances[a], second = distances[b];
    if (first == second || (first > second) == falls) return;
    distances[a] = second;
    distances[b] = first;
    uint flake = order[a];
    order[a] = order[b];
    order[b] = flake;
}
