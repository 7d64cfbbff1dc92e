#version 430 core
// The glass of a lamp that is on: it shines, whatever falls on it.

uniform vec3 own_light;
uniform float lamp_is_on;  // 0 to 1

in vec4 air;  // see air.glsl

out vec4 colour;

void main()
{
    const float brightness = 12.0;
    colour = vec4(air.rgb + air.a * brightness * lamp_is_on * own_light, 1.0);
}
