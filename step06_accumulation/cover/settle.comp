#version 430 core
// Snow that lies steeper than its angle of repose slides into the lower neighbours, over edges, too. What
// one column loses another gains, to the unit.

#include "common/weather_block.glsl"
#include "step06_accumulation/cover/column.glsl"

const ivec3 up = ivec3(0, 1, 0);

// The four columns at the sides, then the four at the corners.
const ivec3 neighbours[8] = ivec3[](ivec3(0, 0, 1), ivec3(1, 0, 0), ivec3(0, 0, -1), ivec3(-1, 0, 0),
                                    ivec3(-1, 0, -1), ivec3(1, 0, -1), ivec3(-1, 0, 1), ivec3(1, 0, 1));

// Moves so much from this column, from the surface `cell` downwards, to `target`, or as much as is
// there and as `target` has room for. Nobody else takes from this column: what was there is there
// still, once it has been added.
void transfer(ivec3 cell, ivec3 target, uint amount)
{
    for (; amount > 0u && mass_in(cell) > 0u; cell -= up) {
        uint portion = min(amount, mass_in(cell));
        uint moved = portion - add_snow(target, portion);
        atomicAdd(mass[mass_index(cell)], 0u - moved);
        if (moved < portion) return;
        amount -= moved;
    }
}

// Slides snow from `cell`, the surface of its column, one column on in `direction`. `base` is the height
// of what the snow lies on, `slope` the greatest difference to the neighbour, in cells.
void slide(ivec3 cell, ivec3 direction, float base, float slope)
{
    ivec3 target = cell + direction;
    if (!in_grid(target) || in_base(target)) return;  // a wall
    if (mass_in(target + up) > 0u) return;             // higher snow
    while (target.y > 0 && mass_in(target) == 0u && !in_base(target - up)) target -= up;
    float height = float(cell.y) + float(mass_in(cell)) / float(full_cell);
    float neighbour = float(target.y) + float(mass_in(target)) / float(full_cell);
    // Where the ground falls away the snow holds together, and the edge is half as far as the neighbour.
    const float cliff = 0.03;  // m
    float highest = max(neighbour + slope, base + cliff / grid.cell_size + 0.5 * slope);  // in cells
    float excess = height - highest;
    if (excess <= 0.0) return;
    transfer(cell, target, uint(0.25 * excess * float(full_cell)));
}

// Moves from `cell` as much as the cell below has room for, if that has lost snow since.
void fall(ivec3 cell)
{
    ivec3 below = cell - up;
    if (cell.y == 0 || in_base(below)) return;
    transfer(cell, below, min(full_cell - mass_in(below), mass_in(cell)));
}

void take_turn(ivec3 cell)
{
    float slope = tan(radians(weather.repose));  // cells of height for one of distance
    float base = 0.0;                            // height of what the snow lies on, in cells
    for (; !is_open_sky(cell); cell += up) {
        // Up to the next snow.
        for (; mass_in(cell) == 0u; cell += up) {
            if (is_open_sky(cell)) return;
            if (in_base(cell)) base = float(cell.y + 1);
        }
        fall(cell);
        // And up to its surface.
        while (mass_in(cell + up) > 0u) cell += up;
        fall(cell);
        for (int side = 0; side < 8 && !in_base(cell + up); ++side) {
            ivec3 surface = cell;
            while (mass_in(surface) == 0u && surface.y > 0) surface -= up;  // it may have slid already
            slide(surface, neighbours[side], base, slope * length(vec3(neighbours[side])));
        }
    }
}
