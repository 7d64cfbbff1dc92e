// The columns of the grid are looked after in turns: each frame a part of them, so that the cost of a
// frame is bounded and every column has its turn once in a round.

#include "step06_accumulation/cover/snow_cover.glsl"

layout(local_size_x = 64) in;

uniform uint first_column, end_column;  // of this frame's part: one past its last

// What is done to a column in its turn; `cell` is its lowest. Whoever includes this defines it.
void take_turn(ivec3 cell);

void main()
{
    uint column = first_column + gl_GlobalInvocationID.x;
    if (column >= end_column) return;  // the last group of invocations may reach further
    take_turn(ivec3(int(column) % resolution, 0, int(column) / resolution));
}

// Does the snow in this cell lie open to the air?
bool is_surface(ivec3 cell)
{
    ivec3 above = cell + ivec3(0, 1, 0);
    return mass_in(cell) > 0u && mass_in(above) == 0u && !in_scene(above);
}
