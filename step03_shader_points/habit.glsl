// What a snow crystal looks like: which picture of the atlas snowflakes.png, whose rows are habits.

#include "common/weather_block.glsl"

const uint plates = 0u, needles = 1u, columns = 2u, sectored_plates = 3u, stars = 4u, dendrites = 5u,
           irregular = 6u, aggregates = 7u;

// The habit in which crystals grow in air of that temperature, degrees Celsius: the bounds of
// Nakaya's diagram (Snow Crystals, 1954), as weather services print them. Magono and Lee (1966,
// figure 2) found the same order in snow that fell.
uint habit(float temperature)
{
    if (temperature > -4.0) return plates;
    if (temperature > -6.0) return needles;
    if (temperature > -10.0) return columns;
    if (temperature > -12.0) return sectored_plates;
    if (temperature > -16.0) return dendrites;
    if (temperature > -22.0) return sectored_plates;
    if (temperature > -30.0) return columns;
    return irregular;  // side planes and other rarities
}

// The tile of a flake in the atlas, 4 x 8 tiles. Flakes of one habit differ; some have fewer
// branches, and some are broken. What is heavy has become so by sticking together.
vec2 crystal_tile(uint index)
{
    uint bits = hash(index);
    uint row = habit(weather.temperature);
    if (row == dendrites && (bits & 12u) == 0u) row = stars;
    if ((bits & 112u) == 0u) row = irregular;
    float size = diameter(index, weather) / weather.emitters[1].diameter;
    // By mass: a quarter more than a mean flake of the heavier kind.
    if (size * size * size > 1.25) row = aggregates;
    return vec2(bits & 3u, 7u - row);  // the texture's first row is the lowest
}

// Its opacity at uv from (-1, -1) to (1, 1) across the flake.
float crystal_opacity(sampler2D crystals, vec2 tile, vec2 uv)
{
    return texture(crystals, (tile + 0.5 + 0.5 * uv) / vec2(4.0, 8.0)).a;
}
