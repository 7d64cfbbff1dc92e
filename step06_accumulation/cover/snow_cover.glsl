// The snow that lies: a mass for every cell of the voxel grid, in units of which full_cell fill it.
// Whole numbers, so that atomicAdd in any order gives the same sum, to the unit.

#include "common/bindings.glsl"
#include "step05_collision/voxels.glsl"

layout(std430, binding = COVER_BUFFER) coherent buffer SnowCover { uint mass[]; };
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
    return uint(cell.x + grid.resolution * (cell.y + grid.resolution * cell.z));
}

uint mass_in(ivec3 cell)
{
    return in_grid(cell) ? mass[mass_index(cell)] : 0u;
}

// What snow can lie on but does not make: the scene, and beside it the ground, which is the lowest
// layer of cells.
bool in_base(ivec3 cell)
{
    return in_scene(cell) || (in_grid(cell) && cell.y == 0);
}

// What a flake lands on: that, or a cell that snow has filled.
bool solid(ivec3 cell)
{
    return in_base(cell) || mass_in(cell) >= full_cell;
}

// Adds to a cell as much as it has room for, and what is over to the cells above, up to a ceiling
// or to the top of the grid. Returns what found no room. No cell ever holds more than it can, not
// even for a moment: atomicAdd would add first and tell afterwards, atomicCompSwap adds only if
// nobody else has changed the cell in between.
uint add_snow(ivec3 cell, uint amount)
{
    const int most_attempts = 512;  // what is not placed by then finds no room, either
    for (int n = 0; n < most_attempts && amount > 0u && in_grid(cell) && !in_base(cell); ++n) {
        uint held = mass_in(cell);
        uint portion = min(amount, full_cell - held);
        if (atomicCompSwap(mass[mass_index(cell)], held, held + portion) != held) continue;  // once more
        amount -= portion;
        cell.y += 1;
    }
    return amount;
}
