#version 430 core
// Hands a point of the lamp's glass on to the screen.

#include "step06_accumulation/winter/camera/camera.glsl"

layout(location = 0) in vec3 position;

out vec3 world_position;  // m

void main()
{
    world_position = position;
    gl_Position = camera.projection * camera.view * vec4(position, 1.0);
}
