// The weather as shaders see it: a uniform block, filled by UniformBlock<snow::Weather>.

#include "common/snow.glsl"

layout(std140) uniform WeatherBlock
{
    Weather weather;
};
