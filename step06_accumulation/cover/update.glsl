// One time step of one flake, as in step 5, but what has lain for its time becomes part of the snow
// cover. A compute shader makes it, in place: a vertex shader may run more than once for a vertex,
// and would deposit a flake twice (OpenGL 4.3, 7.12.1).

#include "common/weather_block.glsl"
#include "step05_collision/ledger.glsl"
#include "step06_accumulation/cover/snow_cover.glsl"
#include "step05_collision/release.glsl"

layout(local_size_x = 128) in;

uniform uint tick;         // number of the time step
uniform uint first;        // index of the flake that this piece of the buffer begins with
uniform float flake_mass;  // units for each cubic metre of the cube around a flake

layout(std430, binding = FLAKES_BUFFER) buffer Flakes { Particle flakes[]; };

vec3 air_at(vec3 position);  // m/s, velocity of the air there

// What becomes of a flake p that has just moved in a straight line from `from`.
Particle collide(vec3 from, Particle p, Weather weather);

// Adds so many units of mass to the snow at `position`, and counts them. Returns false if none found room.
bool deposit(vec3 position, uint flake);

// What a flake weighs, in units: the more the larger it is. Rounded up as often as it takes: of ten
// million flakes one may weigh less than a unit, and their sum has to be right.
uint mass_of(uint index)
{
    float d = diameter(index, weather), chance = random_unit(index, tick, 4u, weather);
    return uint(min(flake_mass * d * d * d + chance, 1.0e8));  // 36 times as much still fits into a word
}

// How much of a flake goes to the column that is x and z columns off, 2 at most: a bell (binomial weights).
// Whole flakes in single columns would make a chequerboard.
uint portion_of(uint flake, int x, int z)
{
    const uint weight[5] = uint[](1u, 4u, 6u, 4u, 1u);  // of 16, in x and in z
    return flake * (weight[x + 2] * weight[z + 2]) / 256u;
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
