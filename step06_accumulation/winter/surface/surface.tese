#version 430 core
// A point that tessellation added to a triangle, lifted by the snow where it lies.

#include "step06_accumulation/winter/surface/surface.glsl"

layout(triangles, fractional_odd_spacing, ccw) in;  // even spacing knows no level 1

in Corner control[];

#define BETWEEN(field) (t.x * control[0].field + t.y * control[1].field + t.z * control[2].field)

void main()
{
    vec3 t = gl_TessCoord;
    // The same on an edge, to the last bit, whichever of its two triangles asks: or there would be cracks.
    precise vec3 position = BETWEEN(position);
    precise float displacement = BETWEEN(displacement);
    put_on_snow(Corner(position, BETWEEN(normal), BETWEEN(colour), BETWEEN(uv), displacement, control[0].skirt,
                       BETWEEN(even_normal)));
}
