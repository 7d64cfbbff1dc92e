#version 330 core
// One step of one flake: what the loop of steps 1 to 3 does, as a vertex shader. It draws nothing; its
// four outputs are captured by transform feedback, in the layout of a Particle.

#include "common/snow.glsl"

layout(std140) uniform WeatherBlock { Weather weather; };
uniform uint step_number;

layout(location = 0) in vec3 old_position;
layout(location = 1) in float old_age;
layout(location = 2) in vec3 old_velocity;
layout(location = 3) in float old_rest;

out vec3 position;
out float age;
out vec3 velocity;
out float rest;

void main()
{
    Particle p = Particle(old_position, old_age, old_velocity, old_rest);
    p = advance(p, uint(gl_VertexID), step_number, weather);
    position = p.position;
    age = p.age;
    velocity = p.velocity;
    rest = p.rest;
}
