// What happens to the snow that lies, on the GPU, column by column: it slides, it melts, and its
// depth is measured.
#pragma once

#include <GL/glew.h>

#include "common/program.hpp"
#include "step05_collision/scene_collider.hpp"
#include "step05_collision/solid_scene.hpp"

class Columns {
public:
    explicit Columns(const VoxelGrid& grid)
        : columns_(unsigned(grid.resolution * grid.resolution)),
          settle_({{GL_COMPUTE_SHADER, "step06_accumulation/settle.comp"}}),
          melt_({{GL_COMPUTE_SHADER, "step06_accumulation/melt.comp"}}),
          measure_({{GL_COMPUTE_SHADER, "step06_accumulation/depth.comp"}}), depth_(make_texture())
    {
        glBindTexture(GL_TEXTURE_3D, depth_);
        glTexStorage3D(GL_TEXTURE_3D, 1, GL_R16F, grid.resolution, grid.resolution,
                       grid.resolution);
        const float unknown = -1;
        glClearTexImage(depth_, 0, GL_RED, GL_FLOAT, &unknown);
    }

    // All three give a part of the columns their turn; `step` says which.
    void settle(unsigned step, const SolidScene& solid) { dispatch(settle_, step, solid); }

    void melt(unsigned step, const SolidScene& solid, const snow::Weather& weather)
    {
        if (weather.temperature <= 0) return;
        melt_.use();
        melt_.set("seconds", turns * weather.time_step);
        dispatch(melt_, step, solid);
    }

    void measure(unsigned step, const SolidScene& solid)
    {
        glBindImageTexture(0, depth_, 0, GL_TRUE, 0, GL_READ_WRITE, GL_R16F);
        dispatch(measure_, step, solid);
    }

    // Gives the depth of the snow to the program in use, on texture unit 5.
    void set_depth(Program& program) const
    {
        program.set("snow_depth", 5);
        glActiveTexture(GL_TEXTURE5);
        glBindTexture(GL_TEXTURE_3D, depth_);
        glActiveTexture(GL_TEXTURE0);
    }

private:
    static constexpr unsigned turns = 64;  // steps in a round

    void dispatch(Program& program, unsigned step, const SolidScene& solid)
    {
        const unsigned count = columns_ / turns;
        program.use();
        set_voxels(program, solid.grid, solid.voxels);
        program.set("first_column", step % turns * count);
        glDispatchCompute((count + 63) / 64, 1, 1);  // 64: local_size_x of the shaders
        glMemoryBarrier(GL_SHADER_STORAGE_BARRIER_BIT | GL_TEXTURE_FETCH_BARRIER_BIT |
                        GL_SHADER_IMAGE_ACCESS_BARRIER_BIT);
    }

    unsigned columns_;
    Program settle_, melt_, measure_;
    GlObject depth_;
};
