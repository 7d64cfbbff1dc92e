// The numbers of the weather that a user may change.
#include "common/weather.hpp"

namespace snow {

std::vector<Parameter> weather_parameters(Weather& weather)
{
    return {
        {"gravity", "m/s2", -30, -0.1f, "pull of the earth along y", &weather.gravity.y},
        {"turbulence", "m/s2", 0, 50, "largest random push on a flake, along each axis",
         &weather.turbulence},
        {"wind_x", "m/s", -30, 30, "wind towards +x", &weather.wind.x},
        {"wind_z", "m/s", -30, 30, "wind towards +z", &weather.wind.z},
        {"melt_time", "s", 0, 600, "time a flake lies on a surface", &weather.melt_time},
        {"lifetime", "s", 0.1f, 600, "mean time after which a flake in the air is lost",
         &weather.lifetime},
        {"variation", "", 0, 0.9f, "relative spread of speed and size", &weather.variation},
        {"snowfall", "m/min", 0, 10, "depth that comes to lie on open ground (step 6)",
         &weather.snowfall},
        {"temperature", "C", -30, 30, "of the air; above 0 the snow that lies melts (step 6)",
         &weather.temperature},
        {"repose", "degrees", 5, 80, "steepest slope on which snow lies (step 6)", &weather.repose},
        {"restitution", "", 0, 0.9f, "part of its speed that a flake keeps when it bounces",
         &weather.restitution},
        {"speed_0", "m/s", 0.1f, 300, "mean terminal speed of emitter 0's flakes",
         &weather.emitters[0].terminal_speed},
        {"speed_1", "m/s", 0.1f, 300, "mean terminal speed of emitter 1's flakes",
         &weather.emitters[1].terminal_speed},
        {"diameter_0", "m", 0.001f, 1, "mean diameter of emitter 0's flakes as drawn",
         &weather.emitters[0].diameter},
        {"diameter_1", "m", 0.001f, 1, "mean diameter of emitter 1's flakes as drawn",
         &weather.emitters[1].diameter},
    };
}

}  // namespace snow
