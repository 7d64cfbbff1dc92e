#version 430 core
// A vertex of the scene, lifted at once: the whole surface is no finer than the mesh.

#include "step06_accumulation/winter/surface/corner_here.glsl"
#include "step06_accumulation/winter/surface/surface.glsl"

void main()
{
    put_on_snow(corner_here());
}
