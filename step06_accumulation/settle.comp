#version 430 core
// Snow that lies steeper than its angle of repose slides into the lower neighbour, over edges, too. What
// one column loses another gains, to the unit.

#include "common/snow.glsl"
#include "step06_accumulation/column.glsl"

layout(std140) uniform WeatherBlock { Weather weather; };

const ivec3 up = ivec3(0, 1, 0);

// Slides snow from `cell`, the surface of its column, one column on in `direction`. `height` is that of
// the surface, `base` that of what the snow lies on, in cells. Returns the mass that left.
uint slide(ivec3 cell, ivec3 direction, float height, float base, float slope)
{
    ivec3 target = cell + direction;
    if (!in_grid(target) || in_scene(target)) return 0u;      // a wall
    if (mass_in(target + up) > 0u) return 0u;                 // higher snow
    while (target.y > 0 && mass_in(target) == 0u && !in_scene(target - up)) target -= up;
    // Where the ground falls away the snow holds together, a cell high.
    float neighbour = max(float(target.y) + float(mass_in(target)) / float(full_cell), base + 1.0);
    float excess = height - neighbour - slope;
    if (excess <= 0.0) return 0u;
    uint amount = min(uint(0.25 * excess * float(full_cell)), mass_in(cell));
    add_snow(target, amount);
    return amount;
}

void main()
{
    float slope = tan(radians(weather.repose));  // cells of height for one of distance
    ivec3 cell = foot_of_column();
    float base = 0.0;
    for (; cell.y < resolution; ++cell.y) {
        if (in_scene(cell)) base = float(cell.y + 1);
        if (!is_surface(cell)) continue;
        for (int side = 0; side < 4; ++side) {
            ivec3 direction = ivec3(side == 0 ? 1 : side == 1 ? -1 : 0, 0, side == 2 ? 1 : side == 3 ? -1 : 0);
            float height = float(cell.y) + float(mass_in(cell)) / float(full_cell);
            uint amount = slide(cell, direction, height, base, slope);
            // Only this invocation takes from this column, so what was there is there still.
            if (amount > 0u) atomicAdd(mass[mass_index(cell)], 0u - amount);
        }
    }
}
