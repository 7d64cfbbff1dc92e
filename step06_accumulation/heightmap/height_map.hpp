// The scene as it is seen from above, and the snow that lies on it, for the shaders of the variant
// "heightmap".
#pragma once

#include "common/program.hpp"
#include "step05_collision/solid_scene.hpp"
#include "step06_accumulation/cover/snow_cover.hpp"

class HeightMap {
public:
    // cover: of one layer.
    HeightMap(const SolidScene& solid, const SnowCover& cover);

    // Hands the shaders the height of the scene and the depth of the snow (snow_depth.glsl).
    void bind() const;

    // Lets snow slide in the last `ticks` time steps, up to number `tick`.
    void settle(unsigned tick, int ticks);

private:
    const SnowCover& cover_;
    int resolution_;
    Program settle_;
    GlObject heights_ = make_texture(), lying_ = make_texture();
};
