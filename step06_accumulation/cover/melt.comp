#version 430 core
// Snow melts where it lies open to the air, the faster the warmer it is.

#include "common/weather_block.glsl"
#include "step06_accumulation/cover/column.glsl"

void take_turn(ivec3 cell)
{
    const float rate = 0.01 / 60.0;                   // m/s for each degree: a thaw that can be watched
    float seconds = float(steps_per_round) * weather.time_step;  // since this column's last turn
    uint most = uint(max(weather.temperature, 0.0) * rate * seconds / grid.cell_size * float(full_cell));
    for (; !is_open_sky(cell); ++cell.y) {
        if (!is_surface(cell)) continue;
        uint amount = min(most, mass_in(cell));
        atomicAdd(mass[mass_index(cell)], 0u - amount);
        count_mass(melted_mass, amount);
    }
}
