// All that the variant "winter" has besides the snow that lies: the parts, each in a folder of its
// own with its settings and its shaders, and what they have to do in a frame.
#pragma once

#include <vector>

#include "common/window.hpp"
#include "step06_accumulation/cover/columns.hpp"
#include "step06_accumulation/winter/budget/flake_budget.hpp"
#include "step06_accumulation/winter/budget/live_flakes.hpp"
#include "step06_accumulation/winter/camera/camera_block.hpp"
#include "step06_accumulation/winter/flakes/depth_order.hpp"
#include "step06_accumulation/winter/flakes/flakes.hpp"
#include "step06_accumulation/winter/light/ambient_occlusion.hpp"
#include "step06_accumulation/winter/light/daylight.hpp"
#include "step06_accumulation/winter/light/lamp.hpp"
#include "step06_accumulation/winter/light/shadow_map.hpp"
#include "step06_accumulation/winter/light/sky.hpp"
#include "step06_accumulation/winter/post/bloom.hpp"
#include "step06_accumulation/winter/post/linear_frame.hpp"
#include "step06_accumulation/winter/post/tone.hpp"
#include "step06_accumulation/winter/surface/smooth_snow.hpp"
#include "step06_accumulation/winter/surface/snow_surface.hpp"
#include "step06_accumulation/winter/wind/wind_arrows.hpp"
#include "step06_accumulation/winter/wind/wind_field.hpp"

class Winter {
public:
    Winter(Window& window, const SolidScene& solid, const Columns& columns);

    // The numbers of all parts, for --set and the panel.
    static std::vector<snow::Parameter> parameters();

    // Decides how many flakes live in the next frame.
    void choose_flakes(Window& window, const PingPong& particles);
    const LiveFlakes& live() const { return live_; }

    // Puts a program to use whose shaders include wind_field.glsl.
    Program& use_in_wind(Permutations& all, const snow::Weather& weather) const;

    // Draws it all, each part in a stage of its own. tick: time steps made since the first flake.
    void draw(Window& window, unsigned tick, const PingPong& particles);

private:
    const SolidScene& solid_;
    const Columns& columns_;
    WindField wind_;
    AmbientOcclusion occlusion_;
    int ticks_before_ = 0;  // time steps of the frame before
    FlakeBudget budget_;
    LiveFlakes live_;
    CameraBlock camera_;
    Daylight daylight_;
    ShadowMap shadow_map_;
    SmoothSnow smooth_snow_;
    SnowSurface surface_;
    Sky sky_;
    Lamp lamp_;
    WindArrows arrows_;
    Flakes flakes_;
    DepthOrder depth_order_;
    LinearFrame frame_;
    Bloom bloom_;
    Tone tone_;
};
