#include "step06_accumulation/winter/settings.hpp"

std::vector<snow::Parameter> Settings::parameters()
{
    using snow::under;
    constexpr bool costly = true;
    std::vector<snow::Parameter> all;
    for (const auto& group :
         {under("Surface", {{"scene", "scene", "on/off", 0, 1,
                             "the scene and the field, or only flakes", &scene},
                            {"tessellation", "tessellation", "on/off", 0, 1,
                             "the surface of the snow is as fine as it needs to be", &tessellation,
                             0, "", costly},
                            {"dusting", "dusting", "on/off", 0, 1,
                             "snow clings to walls that the wind blows against", &dusting},
                            {"sparkle", "sparkle", "on/off", 0, 1,
                             "crystals on the snow flash in the sun", &sparkle}}),
          cover.parameters(),
          under("Flakes",
                {{"billboards", "crystals", "on/off", 0, 1,
                  "flakes are crystals, drawn out along their way", &billboards},
                 {"around", "around", "on/off", 0, 1, "in the air beside the clouds, too", &around},
                 {"splashes", "splashes", "on/off", 0, 1, "of drops that reach the ground",
                  &splashes},
                 {"blur", "out of focus", "on/off", 0, 1,
                  "flakes close to the camera are large and soft", &blur},
                 {"sorted", "back to front", "on/off", 0, 1,
                  "flakes close by hide those behind them", &sorted},
                 {"colours", "colours", "", 0, 3,
                  "of flakes: 0 their own, 1 by speed, 2 by age, 3 by emitter", &colours}}),
          under("Wind", {{"wind_field", "around the scene", "on/off", 0, 1,
                          "the wind flows around the scene", &wind_field},
                         {"arrows", "arrows", "on/off", 0, 1,
                          "the wind as arrows, the redder the faster", &arrows, 'W'},
                         {"gusts", "gusts", "", 0, 2,
                          "largest change of the wind in a gust, relative", &gusts}}),
          under("Light and air",
                {{"sky", "sky", "on/off", 0, 1, "the sky behind the scene", &sky},
                 {"shadow", "shadows", "on/off", 0, 1,
                  "the scene keeps the sun from what lies behind it", &shadow},
                 {"occlusion", "ambient occlusion", "on/off", 0, 1,
                  "it is darker where less of the sky is seen", &occlusion},
                 {"fog", "fog", "on/off", 0, 1,
                  "the air, and more so with snow in it, hides what is far", &fog},
                 {"lamp", "lamp", "on/off", 0, 1, "the lamp, lit from dusk on", &lamp},
                 {"sun_height", "height of the sun", "degrees", -20, 80,
                  "of the sun above the horizon", &sun_height},
                 {"sun_direction", "direction of the sun", "degrees", 0, 360,
                  "where the sun stands, from +z towards +x", &sun_direction},
                 {"overcast", "overcast", "", 0, 1,
                  "how much of the sky is clouds that hide the sun; rain makes it 1", &overcast},
                 {"soft_shadows", "soft shadows", "on/off", 0, 1, "along the edges of shadows",
                  &soft_shadows, 0, "", costly}}),
          under("Picture", {{"multisample", "smooth edges", "on/off", 0, 1,
                             "four samples a pixel along edges", &multisample, 0, "", costly},
                            {"bloom", "glow", "", 0, 0.5f,
                             "fraction of the light that spreads around what is bright", &bloom, 0,
                             "", costly},
                            {"exposure", "exposure", "", 0.1f, 10, "of the picture", &exposure}}),
          under("Frame rate",
                {{"hold_fps", "hold", "fps", 0, 240,
                  "frame rate to hold by moving fewer flakes; 0: none", &hold_fps},
                 {"live", "fraction that moves", "", 0.01f, 1,
                  "fraction of the flakes that moves at most, each the heavier", &live}})}) {
        all.insert(all.end(), group.begin(), group.end());
    }
    return all;
}
