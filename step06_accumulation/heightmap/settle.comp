#version 430 core
// Snow that lies steeper than its angle of repose slides into the lower neighbours, as in cover/settle.comp.

#include "common/weather_block.glsl"
#include "step06_accumulation/cover/column.glsl"
#include "step06_accumulation/heightmap/height_map.glsl"

// m, of the snow in a column.
float snow_in(ivec2 column)
{
    return float(mass[index_of(column)]) / float(full_cell) * grid.cell_size;
}

void take_turn(ivec3 cell)
{
    const float cliff = 0.03;  // m, up to which snow holds together where the ground falls away
    ivec2 here = cell.xz;
    for (int i = 0; i < 9; ++i) {
        ivec2 offset = ivec2(i % 3, i / 3) - 1, there = here + offset;
        if (i == 4 || !in_map(there)) continue;
        float slope = tan(radians(weather.repose)) * grid.cell_size * length(vec2(offset));  // m
        float excess = min(height_at(here) + snow_in(here) - height_at(there) - snow_in(there) - slope,
                           snow_in(here) - cliff - 0.5 * slope);
        if (excess <= 0.0) continue;
        uint moved = min(uint(0.25 * excess / grid.cell_size * float(full_cell)), mass[index_of(here)]);
        atomicAdd(mass[index_of(here)], 0u - moved);
        atomicAdd(mass[index_of(there)], moved);
    }
}
