#version 430 core
// A point that tessellation added to a triangle, lifted by the snow where it lies.

#include "step06_accumulation/winter/surface/surface.glsl"

layout(triangles, fractional_odd_spacing, ccw) in;  // even spacing knows no level 1

in Corner control[];

void main()
{
    vec3 t = gl_TessCoord;
    // The same on an edge, to the last bit, whichever of its two triangles asks: or there would be cracks.
    precise vec3 position = t.x * control[0].position + t.y * control[1].position + t.z * control[2].position;
    precise float displacement =
        t.x * control[0].displacement + t.y * control[1].displacement + t.z * control[2].displacement;
    Corner between;
    between.position = position;
    between.normal = t.x * control[0].normal + t.y * control[1].normal + t.z * control[2].normal;
    between.colour = t.x * control[0].colour + t.y * control[1].colour + t.z * control[2].colour;
    between.uv = t.x * control[0].uv + t.y * control[1].uv + t.z * control[2].uv;
    between.displacement = displacement;
    between.skirt = control[0].skirt;
    between.even_normal =
        t.x * control[0].even_normal + t.y * control[1].even_normal + t.z * control[2].even_normal;
    put_on_snow(between);
}
