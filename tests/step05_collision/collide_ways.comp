#version 430 core
// Lets each flake of a buffer collide on a way of its own, for walk_test.cpp.

#include "common/weather_block.glsl"
#include "step05_collision/collide_voxels.glsl"

layout(local_size_x = 64) in;

struct Way {
    vec3 from;      // m
    float unused;   // fills the row of four
    Particle flake;  // that has just moved
};
layout(std430, binding = 0) buffer Ways { Way ways[]; };

void main()
{
    uint i = gl_GlobalInvocationID.x;
    if (i < uint(ways.length())) ways[i].flake = collide(ways[i].from, ways[i].flake, weather);
}
