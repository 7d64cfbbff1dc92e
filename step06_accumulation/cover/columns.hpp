// What happens to the snow that lies, on the GPU, column by column: it slides, it melts, and its
// depth is measured.
#pragma once

#include <GL/glew.h>

#include <vector>

#include "common/program.hpp"
#include "common/weather.hpp"
#include "step05_collision/solid_scene.hpp"
#include "step06_accumulation/cover/snow_cover.hpp"

// The switches of the snow that lies.
struct CoverSettings {
    bool settling = true;  // snow steeper than its angle of repose slides
    bool melting = true;   // snow melts where it is warmer than 0 degrees

    std::vector<snow::Parameter> parameters();
};

// A 3D texture with n texels along each edge, filtered, in which all is 0.
GlObject make_volume(GLint format, int n);

// Runs a compute shader of column.glsl, `program`, which is in use, on the columns of a grid whose
// turn it was in the last `ticks` time steps, up to number `tick`.
void dispatch_turns(Program& program, int resolution, unsigned tick, int ticks);

class Columns {
public:
    Columns(const SolidScene& solid, const SnowCover& cover);

    // Time steps in a round, in which every column has its turn once.
    static constexpr unsigned steps_per_round = 64;

    // What the last `ticks` time steps, up to number `tick`, have to do; in each one column of 64
    // has its turn.
    void settle(unsigned tick, int ticks) { dispatch(settle_, tick, ticks); }
    void melt(unsigned tick, int ticks, const snow::Weather& weather);
    void measure(unsigned tick, int ticks);

    // Has a compute shader of column.glsl do its work in those time steps.
    void dispatch(Program& program, unsigned tick, int ticks) const;

    // The depths, as depth.comp leaves them.
    GLuint depth() const { return depth_; }

private:
    const SolidScene& solid_;
    const SnowCover& cover_;
    Program settle_, melt_, measure_;
    GlObject depth_;
    int scene_top_ = 1;  // the lowest layer of cells above all of the scene
};
