// The snow that lies: a mass for every cell of the voxel grid, in units of which full_cell fill it.
// Whole numbers, so that atomicAdd in any order gives the same sum, to the unit.

#include "common/bindings.glsl"
#include "step05_collision/voxels.glsl"

layout(std430, binding = COVER_BUFFER) buffer SnowCover { uint mass[]; };
layout(std430, binding = SUMS_BUFFER) buffer MassSums { uint sums[]; };

const uint full_cell = 65536u;

// What has come and what has gone, each counted for itself: together they prove, at exit, that no mass was
// lost on the way. A sum has two words, the low one and its carries.
const uint deposited_mass = 0u, melted_mass = 2u;

void count_mass(uint sum, uint amount)
{
    uint before = atomicAdd(sums[sum], amount);
    if (before + amount < before) atomicAdd(sums[sum + 1u], 1u);
}

uint mass_index(ivec3 cell)
{
    return uint(cell.x + resolution * (cell.y + resolution * cell.z));
}

uint mass_in(ivec3 cell)
{
    return in_grid(cell) ? mass[mass_index(cell)] : 0u;
}

// What a flake lands on: the scene, or a cell that snow has filled.
bool solid(ivec3 cell)
{
    return in_scene(cell) || mass_in(cell) >= full_cell;
}

// Adds to a cell as much as it still holds, and what is over to the cells above.
void add_snow(ivec3 cell, uint amount)
{
    const int most_layers = 256;
    for (int layer = 0; layer < most_layers && amount > 0u && in_grid(cell); ++layer) {
        // Between these two lines other flakes may see the cell too full; in the end it is not.
        uint sum = atomicAdd(mass[mass_index(cell)], amount) + amount;
        ivec3 above = cell + ivec3(0, 1, 0);
        bool has_room = layer + 1 < most_layers && in_grid(above) && !in_scene(above);
        uint over = sum > full_cell && has_room ? min(amount, sum - full_cell) : 0u;
        if (over > 0u) atomicAdd(mass[mass_index(cell)], 0u - over);
        amount = over;
        cell = above;
    }
}
