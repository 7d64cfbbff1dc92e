#version 430 core
// A point that tessellation added to a triangle, lifted by the snow at its own place.

#include "step06_accumulation/winter/surface/surface.glsl"

layout(triangles, fractional_odd_spacing, ccw) in;  // even spacing knows no level 1

in Corner { vec3 position, normal, colour; vec2 uv; float lift, skirt; vec4 even; } control[];

void main()
{
    vec3 part = gl_TessCoord;
    // The same on an edge, to the last bit, whichever of its two triangles asks: or there would be cracks.
    precise vec3 position =
        part.x * control[0].position + part.y * control[1].position + part.z * control[2].position;
    precise vec4 even = part.x * control[0].even + part.y * control[1].even + part.z * control[2].even;
    put_on_snow(position,
                part.x * control[0].normal + part.y * control[1].normal + part.z * control[2].normal,
                part.x * control[0].colour + part.y * control[1].colour + part.z * control[2].colour,
                part.x * control[0].uv + part.y * control[1].uv + part.z * control[2].uv,
                part.x * control[0].lift + part.y * control[1].lift + part.z * control[2].lift,
                control[0].skirt, even);
}
