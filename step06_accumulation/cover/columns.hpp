// What happens to the snow that lies, on the GPU, column by column: it slides, it melts, and its
// depth is measured.
#pragma once

#include <GL/glew.h>

#include <vector>

#include "common/program.hpp"
#include "common/weather.hpp"
#include "step05_collision/solid_scene.hpp"
#include "step06_accumulation/cover/snow_cover.hpp"

class Columns {
public:
    Columns(const SolidScene& solid, const SnowCover& cover);

    // The switches "settling" and "melting".
    static std::vector<snow::Parameter> parameters();
    inline static bool settling = true, melting = true;

    // Time steps in a round, in which every column has its turn once.
    static constexpr unsigned turns = 64;

    // What the last `ticks` time steps, up to number `tick`, have to do; in each a part of the
    // columns has its turn.
    void settle(unsigned tick, int ticks);
    void melt(unsigned tick, int ticks, const snow::Weather& weather);
    void measure(unsigned tick, int ticks);

    // Runs a compute shader of column.glsl, `program`, on the columns whose turn it was in those
    // time steps: one in 8 x 8 in each.
    void dispatch(Program& program, unsigned tick, int ticks) const;

    // The depths, as depth.comp leaves them.
    GLuint depth() const { return depth_; }

    // Gives the program in use the depth of the snow, as snow_depth.glsl looks for it.
    void set_depth(Program& program) const;

private:
    void clear_depth();

    const SolidScene& solid_;
    const SnowCover& cover_;
    Program settle_, melt_, measure_;
    GlObject depth_;
    int scene_top_ = 1;  // the lowest layer of cells above all of the scene
};
