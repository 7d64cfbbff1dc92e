#version 430 core
// Hands a point of the lamp's glass on to the screen.

#include "step06_accumulation/winter/light/air.glsl"

layout(location = 0) in vec3 position;

out vec4 air;

void main()
{
    air = air_before(position);
    gl_Position = camera.projection * camera.view * vec4(position, 1.0);
}
