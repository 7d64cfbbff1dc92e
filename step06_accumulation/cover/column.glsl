// The columns of the grid are looked after in turns: in each time step every 64th row of them, so that the cost of
// a frame is bounded and every column has its turn once in a round. No two neighbours have theirs at once: what a
// column reads of its neighbours, and what it gives to them, nobody else touches meanwhile.

#include "step06_accumulation/cover/snow_cover.glsl"

layout(local_size_x = 64) in;

const ivec2 stride = ivec2(4, 64);  // to the next columns that have their turn at once, along x and z
uniform int first_x, first_z;       // of these columns

// What is done to a column in its turn; `cell` is its lowest. Whoever includes this defines it.
void take_turn(ivec3 cell);

void main()
{
    ivec2 column = ivec2(first_x, first_z) + stride * ivec2(gl_GlobalInvocationID.xy);
    if (any(greaterThanEqual(column, ivec2(resolution)))) return;  // a group may reach beyond the grid
    take_turn(ivec3(column.x, 0, column.y));
}

// Does the snow in this cell lie open to the air?
bool is_surface(ivec3 cell)
{
    ivec3 above = cell + ivec3(0, 1, 0);
    return mass_in(cell) > 0u && mass_in(above) == 0u && !in_base(above);
}
