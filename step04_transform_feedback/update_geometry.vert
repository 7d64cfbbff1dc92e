#version 330 core
// One time step of one flake, as update.vert makes it. update.geom decides which flakes are kept.

#include "step04_transform_feedback/flake_state.glsl"

layout(location = 4) in uint old_index;

out Particle moved;
out uint moved_index;
out float was_born;  // 1: this flake is born in this time step

void main()
{
    bool waited = old_age < 0.0;  // until now: only flakes whose time has come get here
    moved = accelerate(settle(move(load_flake(), weather), weather), weather.wind, old_index, tick, weather);
    was_born = waited || gone(moved, old_index, weather) ? 1.0 : 0.0;
    if (was_born == 1.0) moved = born(old_index, tick, weather);
    moved_index = old_index;
}
