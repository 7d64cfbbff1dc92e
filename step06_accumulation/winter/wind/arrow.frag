#version 430 core
// An arrow of the wind, in its own colour whatever the light.

in vec3 arrow_colour;

out vec4 colour;

void main()
{
    colour = vec4(arrow_colour, 1.0);
}
