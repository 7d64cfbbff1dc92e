// The columns of the grid are looked after in turns: in each time step one of every 8 x 8, so that
// the cost of a frame is bounded and every column has its turn once in a round of 64. No two
// neighbours have theirs at once: what a column reads of its neighbours, and what it gives to them,
// nobody else touches meanwhile.

#include "step06_accumulation/cover/snow_cover.glsl"

layout(local_size_x = 8, local_size_y = 8) in;

uniform int first_x, first_z;  // of the columns that have their turn at once
uniform int stride;            // from each to the next, along x and z
uniform int scene_top;         // the lowest layer of cells above all of the scene

const int steps_per_round = 64;  // time steps in which every column has its turn once

// Does to a column what its turn is for. cell: its lowest.
void take_turn(ivec3 cell);

void main()
{
    ivec2 column = ivec2(first_x, first_z) + stride * ivec2(gl_GlobalInvocationID.xy);
    if (any(greaterThanEqual(column, ivec2(grid.resolution)))) return;  // a group may reach beyond the grid
    take_turn(ivec3(column.x, 0, column.y));
}

// Is there nothing but air from this cell on up? Above the scene snow lies in one piece.
bool is_open_sky(ivec3 cell)
{
    return cell.y >= grid.resolution || (cell.y >= scene_top && mass_in(cell) == 0u);
}

// Does the snow in this cell lie open to the air?
bool is_surface(ivec3 cell)
{
    ivec3 above = cell + ivec3(0, 1, 0);
    return mass_in(cell) > 0u && mass_in(above) == 0u && !in_base(above);
}

// Moves `cell` up to the first one above the next surface of the scene. False: there is none.
bool next_surface(inout ivec3 cell)
{
    while (cell.y < scene_top && !in_base(cell)) ++cell.y;
    if (cell.y >= scene_top) return false;
    while (in_base(cell)) ++cell.y;
    return cell.y < grid.resolution;
}
