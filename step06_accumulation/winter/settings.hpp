// All that the user may change in the winter, with --set or in the panel.
#pragma once

#include <vector>

#include "common/weather.hpp"
#include "step06_accumulation/cover/columns.hpp"

struct Settings {
    CoverSettings cover;

    // Surface
    bool scene = true, tessellation = true, dusting = true, sparkle = true;
    // Flakes
    bool billboards = true, around = true, splashes = true, blur = true, sorted = false;
    float colours = 0;  // 0 their own, 1 by speed, 2 by age, 3 by emitter
    // Wind
    bool wind_field = true, arrows = false;
    float gusts = 0.3f;  // largest change of the wind in a gust, relative
    // Light and air
    bool sky = true, shadow = true, soft_shadows = true, occlusion = true, fog = true, lamp = true;
    float sun_height = 20, sun_direction = 118;  // degrees
    float overcast = 0;                          // 0 clear to 1: no sun comes through; rain is 1
    static constexpr float lamp_off_height = 4;  // of the sun: from there on up no lamp is on
    // Picture
    bool multisample = true;
    float bloom = 0.06f;  // fraction of the light that is spread; 0: none
    float exposure = 1;
    // Frame rate
    float hold_fps = 0;  // frames a second to hold; 0: none
    float live = 1;      // the largest fraction of the flakes that moves, 0.01 to 1

    // The table of them all, which points into this struct.
    std::vector<snow::Parameter> parameters();
};
