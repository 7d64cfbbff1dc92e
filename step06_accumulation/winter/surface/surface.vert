#version 430 core
// A vertex of the scene: lifted at once, so that the whole surface is no finer than the mesh; or TESSELLATED, a
// corner of a patch, which waits for the vertices that tessellation adds.

#include "step06_accumulation/winter/surface/surface.glsl"

layout(location = 0) in vec3 position;
layout(location = 1) in vec3 normal;
layout(location = 2) in vec3 colour;
layout(location = 3) in vec2 uv;
layout(location = 4) in float displacement;
layout(location = 5) in float skirt;
layout(location = 6) in vec3 even_normal;

#ifdef TESSELLATED
out Corner corner;
#endif

void main()
{
    Corner here = Corner(position, normal, colour, uv, displacement, skirt, even_normal);
#ifdef TESSELLATED
    corner = here;
#else
    put_on_snow(here);
#endif
}
