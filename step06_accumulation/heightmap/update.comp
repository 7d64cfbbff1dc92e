#version 430 core
// The variant "heightmap": a flake lands on what is seen from above, and adds its mass to the column there.

#include "step06_accumulation/cover/update.glsl"
#include "step06_accumulation/heightmap/height_map.glsl"

vec3 air_at(vec3 position)
{
    return weather.wind;
}

// m, of the layers of cells that the scene reaches up to, and of those that its snow would fill: as in "cells".
float surface_at(ivec2 column)
{
    uint snow = in_map(column) ? mass[index_of(column)] / full_cell : 0u;
    float scene = floor((height_at(column) - grid.origin.y) / grid.cell_size) + 1.0;
    return grid.origin.y + grid.cell_size * (scene + float(snow));
}

bool open_sky(vec3 position)
{
    return position.y >= surface_at(column_of(position));
}

// A column that is higher than where the flake comes from is a wall: it falls down along that.
Particle collide(vec3 from, Particle p, Weather weather)
{
    if (from.y < surface_at(column_of(p.position))) {
        p.position.xz = from.xz;
        p.velocity.xz = vec2(0.0);
    }
    float surface = surface_at(column_of(p.position));
    if (p.position.y >= surface) return p;
    p.position.y = surface;
    return land(p, weather);
}

// Spreads a flake over the 5 x 5 columns around, but not up walls. A column always has room.
bool deposit(vec3 position, uint flake)
{
    ivec2 centre = column_of(position);
    if (!in_map(centre)) return false;
    uint left = flake;
    for (int x = -2; x <= 2; ++x) {
        for (int z = -2; z <= 2; ++z) {
            ivec2 column = centre + ivec2(x, z);
            if (column == centre || !in_map(column)) continue;
            if (surface_at(column) - surface_at(centre) > 2.0 * grid.cell_size) continue;
            uint portion = portion_of(flake, x, z);
            atomicAdd(mass[index_of(column)], portion);
            left -= portion;
        }
    }
    atomicAdd(mass[index_of(centre)], left);
    count_mass(deposited_mass, flake);
    return true;
}

void main()
{
    if (first + gl_GlobalInvocationID.x < weather.particles) update_flake();
}
