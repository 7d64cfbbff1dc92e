// The numbers of the weather that a user may change.
#include "common/weather.hpp"

namespace snow {

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
                  "part of its speed that a flake keeps when it bounces", &weather.restitution},
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
