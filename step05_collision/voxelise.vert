#version 420 core
// Hands a corner of a triangle on, as it lies in the world.

layout(location = 0) in vec3 position;

out vec3 corner;  // m

void main()
{
    corner = position;
}
