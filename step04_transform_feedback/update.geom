#version 330 core
// Emits a flake or does not: a flake that is gone leaves no trace, and the flakes behind it move up.

#include "common/weather_block.glsl"
#include "step04_transform_feedback/flake_output.glsl"

layout(points) in;
layout(points, max_vertices = 1) out;

uniform bool births;  // emit flakes that are born, in place of those that live on

in Particle moved[];
in uint moved_index[];
in float was_born[];

out uint index;  // of the flake: its position in the buffer does not tell

void main()
{
    if ((was_born[0] == 1.0) != births) return;
    store_flake(moved[0]);
    index = moved_index[0];
    EmitVertex();
}
