// The wind at a point: around the scene it flows as WindField computed it, elsewhere evenly.

#include "common/weather_block.glsl"
#include "step05_collision/grid.glsl"

// Velocity of the air, m/s, for each m/s of wind along x, and along z.
layout(binding = WIND_X_UNIT) uniform sampler3D wind_along_x;
layout(binding = WIND_Z_UNIT) uniform sampler3D wind_along_z;
uniform float gusts;  // largest change of the wind in a gust, relative

// m/s, at `position` at time step number `tick`. Gusts are two slow waves that rarely agree.
vec3 wind_at(vec3 position, uint tick)
{
    float time = float(tick) * weather.time_step;  // s
    float gust = 1.0 + gusts * (0.6 * sin(0.9 * time) + 0.4 * sin(2.3 * time + 1.0));
    vec3 wind = gust * weather.wind;
#ifdef WIND_FIELD
    vec3 uvw = (position - grid.origin) / (grid.cell_size * float(grid.resolution));
    if (any(lessThan(uvw, vec3(0.0))) || any(greaterThan(uvw, vec3(1.0)))) return wind;
    return wind.x * texture(wind_along_x, uvw).xyz + wind.z * texture(wind_along_z, uvw).xyz +
           vec3(0.0, wind.y, 0.0);
#else
    return wind;
#endif
}
