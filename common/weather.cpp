#include "common/weather.hpp"

#include <stdexcept>

namespace snow {

Weather make_weather(const std::string& preset, uint particles, uint seed)
{
    Weather weather{};
    weather.gravity = {0, -9.81f, 0};
    weather.turbulence = 3;
    weather.melt_time = 4;
    weather.world_min = -1;
    weather.time_step = 1.0f / 60.0f;
    weather.world_max = 13;
    weather.lifetime = 40;
    weather.particles = particles;
    weather.seed = seed;
    weather.variation = 0.15f;
    weather.snowfall = 0.1f;    // a blizzard, so that there is something to see within a minute
    weather.temperature = -14;  // in which stars grow, see step 3
    weather.repose = 38;        // of old, coarse snow; fresh snow lies on slopes of about 50
    weather.vortex_size = 4;    // and swirl = 0: none, unless they are asked for
    // Cloud 1 hangs higher than cloud 0 by as much as its flakes fall faster: both halves of the
    // pool are in the air for the same time and release in equal share (pool = rate x flight time,
    // Patrick 2000, 4.2.2.1). Snow falls at 1-2 m/s. Flakes are drawn some ten times too large, or
    // they could not be seen (Patrick 2000, 3.1).
    weather.emitters[0] = {{0, 8, 0}, 1.0f, {8, 0.5f, 8}, 0.05f};
    weather.emitters[1] = {{0, 12, 0}, 1.5f, {8, 0.75f, 8}, 0.08f};
    if (preset == "rain" || preset == "hail") {
        const bool rain = preset == "rain";
        weather.kind = rain ? rain_kind : hail_kind;
        weather.restitution = rain ? 0.0f : 0.3f;
        if (rain) weather.temperature = 4;
        weather.snowfall = rain ? 0.0f : 0.05f;
        weather.turbulence = rain ? 1.0f : 0.5f;
        weather.melt_time = rain ? 0.2f : 6.0f;
        weather.emitters[0].terminal_speed = rain ? 6.0f : 12.0f;
        weather.emitters[1].terminal_speed = rain ? 9.0f : 18.0f;
        weather.emitters[0].diameter = rain ? 0.02f : 0.035f;
        weather.emitters[1].diameter = rain ? 0.028f : 0.05f;
    } else if (preset != "snow") {
        throw std::invalid_argument("no weather is called " + preset);
    }
    return weather;
}

std::vector<Particle> make_flakes(const Weather& weather)
{
    std::vector<Particle> flakes(weather.particles);
    for (uint i = 0; i < weather.particles; ++i) flakes[i] = unborn(i, weather);
    return flakes;
}

std::vector<Parameter> under(const char* heading, std::vector<Parameter> parameters)
{
    for (Parameter& parameter : parameters) parameter.heading = heading;
    return parameters;
}

std::vector<Parameter> weather_parameters(Weather& weather)
{
    Emitter *const low = &weather.emitters[0], *const high = &weather.emitters[1];
    std::vector<Parameter> all;
    for (const auto& group :
         {under("Motion",
                {{"gravity", "gravity", "m/s2", -30, -0.1f, "pull of the earth along y",
                  &weather.gravity.y},
                 {"turbulence", "flutter", "m/s2", 0, 50,
                  "largest random push on a flake, along each axis", &weather.turbulence},
                 {"restitution", "bounce", "", 0, 0.9f,
                  "fraction of its speed that a flake keeps when it bounces", &weather.restitution},
                 {"melt_time", "time to melt", "s", 0, 600, "time a flake lies on a surface",
                  &weather.melt_time},
                 {"lifetime", "lifetime", "s", 0.1f, 600,
                  "mean time after which a flake in the air is lost", &weather.lifetime}}),
          under("Wind",
                {{"wind_x", "wind along x", "m/s", -30, 30, "wind towards +x", &weather.wind.x},
                 {"wind_z", "wind along z", "m/s", -30, 30, "wind towards +z", &weather.wind.z},
                 {"swirl", "vortices", "m/s", 0, 10,
                  "largest speed of vortices in the air, along each axis", &weather.swirl},
                 {"vortex_size", "their size", "m", 0.5f, 50, "how wide a vortex is",
                  &weather.vortex_size}}),
          under("Snow that lies",
                {{"snowfall", "snowfall", "m/min", 0, 10,
                  "depth that comes to lie on open ground (step 6)", &weather.snowfall},
                 {"temperature", "temperature", "C", -40, 30,
                  "of the air; shapes crystals (steps 3, 6); above 0 lying snow melts (step 6)",
                  &weather.temperature},
                 {"repose", "angle of repose", "degrees", 5, 80,
                  "steepest slope on which snow lies (step 6)", &weather.repose}}),
          under("Emitters", {{"speed_0", "speed, low cloud", "m/s", 0.1f, 300,
                              "mean terminal speed of emitter 0's flakes", &low->terminal_speed},
                             {"speed_1", "speed, high cloud", "m/s", 0.1f, 300,
                              "mean terminal speed of emitter 1's flakes", &high->terminal_speed},
                             {"diameter_0", "size, low cloud", "m", 0.001f, 1,
                              "mean diameter of emitter 0's flakes as drawn", &low->diameter},
                             {"diameter_1", "size, high cloud", "m", 0.001f, 1,
                              "mean diameter of emitter 1's flakes as drawn", &high->diameter},
                             {"variation", "variation", "", 0, 0.9f,
                              "relative spread of speed and size", &weather.variation}})}) {
        all.insert(all.end(), group.begin(), group.end());
    }
    return all;
}

}  // namespace snow
