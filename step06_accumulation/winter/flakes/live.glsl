// Which flakes live: the first of each emitter's half of the pool. The others wait for better times.

#include "common/weather_block.glsl"

uniform uint live_of_first, live_of_second;  // flakes of each emitter

bool lives(uint index)
{
    uint half_of_all = weather.particles / 2u;
    return index < half_of_all ? index < live_of_first : index - half_of_all < live_of_second;
}
