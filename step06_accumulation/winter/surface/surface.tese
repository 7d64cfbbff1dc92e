#version 430 core
// A point that tessellation added to a triangle, lifted by the snow at its own place.

#include "step06_accumulation/winter/surface/surface.glsl"

layout(triangles, fractional_odd_spacing, ccw) in;  // even spacing knows no level 1

in Corner control[];

void main()
{
    vec3 part = gl_TessCoord;
    // The same on an edge, to the last bit, whichever of its two triangles asks: or there would be cracks.
    precise vec3 position =
        part.x * control[0].position + part.y * control[1].position + part.z * control[2].position;
    precise vec4 even = part.x * control[0].even + part.y * control[1].even + part.z * control[2].even;
    Corner between;
    between.position = position;
    between.normal = part.x * control[0].normal + part.y * control[1].normal + part.z * control[2].normal;
    between.colour = part.x * control[0].colour + part.y * control[1].colour + part.z * control[2].colour;
    between.uv = part.x * control[0].uv + part.y * control[1].uv + part.z * control[2].uv;
    between.lift = part.x * control[0].lift + part.y * control[1].lift + part.z * control[2].lift;
    between.skirt = control[0].skirt;
    between.even = even;
    put_on_snow(between);
}
