#version 430 core
// One step of one flake, as in step 5, but what has lain for its time becomes part of the snow cover.

#include "step04_transform_feedback/flake_state.glsl"
#include "step05_collision/ledger.glsl"
#include "step06_accumulation/snow_cover.glsl"
#include "step05_collision/voxel_walk.glsl"
#include "step06_accumulation/wind_field.glsl"

uniform uint flake_mass;  // units

// The cell in which snow that comes down into the column of `cell` stays: the first above what is solid.
// Looks no further than two cells up or down; if there is none, the result lies outside the grid.
ivec3 resting_cell(ivec3 cell)
{
    const ivec3 up = ivec3(0, 1, 0);
    for (int climb = 0; climb < 2 && solid(cell); ++climb) cell += up;
    for (int fall = 0; fall < 2 && !solid(cell - up); ++fall) cell -= up;
    return solid(cell) || !solid(cell - up) ? ivec3(-1) : cell;
}

// Adds the flake's mass to the grid, a part to each of the nine columns around: whole flakes in single
// columns would make a chequerboard. Returns false if there is nothing here for snow to lie on.
bool deposit(vec3 position)
{
    ivec3 centre = cell_of(position);
    for (int climb = 0; climb < 256 && solid(centre); ++climb) centre.y += 1;  // it has snowed on the flake
    if (!in_grid(centre) || !solid(centre - ivec3(0, 1, 0))) return false;
    uint left = flake_mass;
    for (int x = -1; x <= 1; ++x) {
        for (int z = -1; z <= 1; ++z) {
            if (x == 0 && z == 0) continue;
            ivec3 cell = resting_cell(centre + ivec3(x, 0, z));
            if (!in_grid(cell)) continue;  // beyond an edge, or a wall
            uint part = x == 0 || z == 0 ? flake_mass / 8u : flake_mass / 16u;
            add_snow(cell, part);
            left -= part;
        }
    }
    add_snow(centre, left);  // a quarter, and what the others did not take
    return true;
}

void main()
{
    uint index = uint(gl_VertexID);
    Particle p = settle(move(load_flake(), weather), weather);
    if (old_age >= 0.0 && old_rest == 0.0) p = collide(old_position, p, weather);
    vec3 air = wind_at(p.position, step_number, weather);
    p = accelerate(p, air, index, step_number, weather);
    if (gone(p, index, weather)) {
        bool has_melted = melt_left(p, weather) < 0.0;
        if (old_age >= 0.0) {
            if (has_melted && flake_mass > 0u && deposit(p.position)) {
                count_deposit();
            } else {
                count_end(has_melted);
            }
        }
        p = born(index, step_number, weather);
        count_release();
    }
    store_flake(p);
}
