#version 430 core
// A corner of a patch: it waits for the vertices that tessellation adds before anything is lifted.

#include "step06_accumulation/winter/surface/corner_here.glsl"

out Corner corner;

void main()
{
    corner = corner_here();
}
