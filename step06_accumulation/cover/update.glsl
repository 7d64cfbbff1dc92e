// One time step of one flake, as in step 5, but what has lain for its time becomes part of the snow
// cover. A compute shader makes it, in place: a vertex shader may run more than once for a vertex,
// and would deposit a flake twice (OpenGL 4.3, 7.12.1).

#include "common/weather_block.glsl"
#include "step05_collision/ledger.glsl"
#include "step06_accumulation/cover/snow_cover.glsl"
#include "step05_collision/voxel_walk.glsl"
#include "step05_collision/open_sky.glsl"
#include "step05_collision/release.glsl"

layout(local_size_x = 128) in;

uniform uint tick;         // number of the time step
uniform uint first;        // index of the flake that this piece of the buffer begins with
uniform float flake_mass;  // units for each cubic metre of the cube around a flake

layout(std430, binding = FLAKES_BUFFER) buffer Flakes { Particle flakes[]; };

vec3 air_at(vec3 position);  // m/s, velocity of the air there

// What a flake weighs, in units: the more the larger it is. Rounded up as often as it takes: of ten
// million flakes one may weigh less than a unit, and their sum has to be right.
uint mass_of(uint index)
{
    float d = diameter(index, weather), chance = random_unit(index, tick, 4u, weather);
    return uint(min(flake_mass * d * d * d + chance, 1.0e8));  // 36 times as much still fits into a word
}

// The cell in which snow that comes down into the column of `cell` stays: the first above what is solid.
// Looks no further than two cells up or down; if there is none, the result lies outside the grid.
ivec3 resting_cell(ivec3 cell)
{
    const ivec3 up = ivec3(0, 1, 0);
    for (int climb = 0; climb < 2 && solid(cell); ++climb) cell += up;
    for (int fall = 0; fall < 2 && !solid(cell - up); ++fall) cell -= up;
    return solid(cell) || !solid(cell - up) ? ivec3(-1) : cell;
}

// Adds a flake's mass to the grid, spread like a bell over the 5 x 5 columns around (binomial
// weights): whole flakes in single columns would make a chequerboard. What finds no room, below a
// ceiling or at the top of the grid, does not count as deposited. Returns false if that is all of
// it, or if there is nothing here to lie on.
bool deposit(vec3 position, uint flake)
{
    const uint weight[5] = uint[](1u, 4u, 6u, 4u, 1u);  // of 16, in x and in z
    ivec3 centre = cell_of(position);
    for (int climb = 0; climb < 256 && solid(centre); ++climb) centre.y += 1;  // it has snowed on the flake
    if (!in_grid(centre) || !solid(centre - ivec3(0, 1, 0))) return false;
    uint left = flake;
    for (int x = -2; x <= 2; ++x) {
        for (int z = -2; z <= 2; ++z) {
            if (x == 0 && z == 0) continue;
            // By way of the column halfway there: snow gets past no wall, however thin.
            ivec3 halfway = ivec3(x / 2, 0, z / 2);
            ivec3 cell = resting_cell(centre + halfway);
            if (in_grid(cell)) cell = resting_cell(cell + ivec3(x, 0, z) - halfway);
            if (!in_grid(cell)) continue;  // beyond an edge, or a wall
            uint portion = flake * (weight[x + 2] * weight[z + 2]) / 256u;
            left -= portion - add_snow(cell, portion);
        }
    }
    left = add_snow(centre, left);  // what is the middle's, and what the others did not take
    count_mass(deposited_mass, flake - left);
    return left < flake;
}

// A flake that is no more: what becomes of it is counted.
void end_flake(Particle p, uint index)
{
    bool has_melted = melt_left(p, weather) < 0.0;
    uint amount = mass_of(index);
    if (has_melted && amount > 0u && deposit(p.position, amount)) {
        count_deposit();
    } else {
        // Rain drains away; snow where no cell takes it has left.
        count_end(has_melted && amount == 0u);
    }
}

// The time step of the invocation's flake.
void update_flake()
{
    uint i = gl_GlobalInvocationID.x, index = first + i;
    Particle old = flakes[i];
    Particle p = settle(move(old, weather), weather);
    if (old.age >= 0.0 && old.rest == 0.0) p = collide(old.position, p, weather);
    p = accelerate(p, air_at(p.position), index, tick, weather);
    if (!goes_on(p, index) || gone(p, index, weather)) {
        if (old.age >= 0.0) end_flake(p, index);
        if (release(p, index, tick)) count_release();
    }
    flakes[i] = p;
}
