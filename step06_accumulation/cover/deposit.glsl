// Where a flake lands among voxels and cells of snow, and to which of them its mass goes.

#include "step06_accumulation/cover/snow_cover.glsl"
#include "step05_collision/voxel_walk.glsl"
#include "step05_collision/open_sky.glsl"

// The cell in which snow that comes down into the column of `cell` stays: the first above what is solid.
// Looks no further than two cells up or down; if there is none, the result lies outside the grid.
ivec3 resting_cell(ivec3 cell)
{
    const ivec3 up = ivec3(0, 1, 0);
    for (int climb = 0; climb < 2 && solid(cell); ++climb) cell += up;
    for (int fall = 0; fall < 2 && !solid(cell - up); ++fall) cell -= up;
    return solid(cell) || !solid(cell - up) ? ivec3(-1) : cell;
}

// Spreads a flake over the 5 x 5 columns around. What finds no room, below a ceiling or at the top of the grid,
// does not count as deposited.
bool deposit(vec3 position, uint flake)
{
    ivec3 centre = cell_of(position);
    for (int climb = 0; climb < 256 && solid(centre); ++climb) centre.y += 1;  // it has snowed on the flake
    if (!in_grid(centre) || !solid(centre - ivec3(0, 1, 0))) return false;
    uint left = flake;
    for (int x = -2; x <= 2; ++x) {
        for (int z = -2; z <= 2; ++z) {
            if (x == 0 && z == 0) continue;
            // By way of the column halfway there: snow gets past no wall, however thin.
            ivec3 halfway = ivec3(x / 2, 0, z / 2);
            ivec3 cell = resting_cell(centre + halfway);
            if (in_grid(cell)) cell = resting_cell(cell + ivec3(x, 0, z) - halfway);
            if (!in_grid(cell)) continue;  // beyond an edge, or a wall
            uint portion = portion_of(flake, x, z);
            left -= portion - add_snow(cell, portion);
        }
    }
    left = add_snow(centre, left);  // what is the middle's, and what the others did not take
    count_mass(deposited_mass, flake - left);
    return left < flake;
}
