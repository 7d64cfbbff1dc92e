// The wind at a point: around the scene it flows as WindField computed it, elsewhere evenly.

#include "common/weather_block.glsl"
#include "step05_collision/grid.glsl"

uniform sampler3D wind_along_x;  // velocity of the air, m/s, for each m/s of wind along x ...
uniform sampler3D wind_along_z;  // ... and along z
uniform float gusts;             // largest change of the wind in a gust, relative

// m/s, at `position` at time step number `tick`. Gusts are two slow waves that rarely agree.
vec3 wind_at(vec3 position, uint tick)
{
    float time = float(tick) * weather.time_step;  // s
    float gust = 1.0 + gusts * (0.6 * sin(0.9 * time) + 0.4 * sin(2.3 * time + 1.0));
    vec3 wind = gust * weather.wind;
#ifdef AROUND_THE_SCENE
    vec3 place = (position - grid_origin) / (cell_size * float(resolution));
    if (any(lessThan(place, vec3(0.0))) || any(greaterThan(place, vec3(1.0)))) return wind;
    return wind.x * texture(wind_along_x, place).xyz + wind.z * texture(wind_along_z, place).xyz +
           vec3(0.0, wind.y, 0.0);
#else
    return wind;
#endif
}
