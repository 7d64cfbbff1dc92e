#version 430 core
// What is cut out of a leaf or a fence by its picture lets the sun through.

#include "step05_collision/picture.glsl"

void main()
{
    with_picture(vec3(0.0));
}
