// The vertex at hand is a corner.

#include "step06_accumulation/winter/surface/corner.glsl"

layout(location = 0) in vec3 position;
layout(location = 1) in vec3 normal;
layout(location = 2) in vec3 colour;
layout(location = 3) in vec2 uv;
layout(location = 4) in float displacement;
layout(location = 5) in float skirt;
layout(location = 6) in vec3 even_normal;

Corner corner_here()
{
    return Corner(position, normal, colour, uv, displacement, skirt, even_normal);
}
