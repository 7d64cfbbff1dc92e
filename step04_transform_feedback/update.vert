#version 330 core
// One time step of one flake: what the loop of steps 1 to 3 does, as a vertex shader. It draws nothing.

#include "step04_transform_feedback/flake_state.glsl"

void main()
{
    store_flake(advance(load_flake(), uint(gl_VertexID), tick, weather));
}
