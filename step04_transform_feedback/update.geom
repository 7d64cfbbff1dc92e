#version 330 core
// One time step of one flake, as update.vert makes it, but a geometry shader need not emit what it was given: a
// flake that is gone leaves no trace, and the flakes behind it move up.

#include "common/weather_block.glsl"
#include "step04_transform_feedback/flake_output.glsl"

layout(points) in;
layout(points, max_vertices = 1) out;

uniform uint tick;    // number of the time step
uniform bool births;  // emit who is born, in place of who lives on

in Flake
{
    vec3 position;
    float age;
    vec3 velocity;
    float rest;
    uint index;
}
flake[];

out uint index;  // which flake it is: its place in the buffer no longer tells

void main()
{
    index = flake[0].index;
    Particle p = Particle(flake[0].position, flake[0].age, flake[0].velocity, flake[0].rest);
    bool waited = p.age < 0.0;  // until now: only those come here whose time it is
    p = accelerate(settle(move(p, weather), weather), weather.wind, index, tick, weather);
    if ((waited || gone(p, index, weather)) != births) return;
    if (births) p = born(index, tick, weather);
    store_flake(p);
    EmitVertex();
}
