// What happens to the snow that lies, on the GPU, column by column: it slides, it melts, and its
// depth is measured.
#pragma once

#include <GL/glew.h>

#include <vector>

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
        clear_depth(grid);
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
    // No snow anywhere; and none can ever be within walls, or where there is nothing to lie on.
    void clear_depth(const VoxelGrid& grid)
    {
        constexpr GLbyte unknown = -127;  // as a texture: -1
        const int n = grid.resolution;
        const auto index = [n](int x, int y, int z) {
            return (size_t(z) * size_t(n) + size_t(y)) * size_t(n) + size_t(x);
        };
        std::vector<GLbyte> depth(size_t(n) * size_t(n) * size_t(n), unknown);
        for (int z = 0; z < n; ++z) {
            for (int x = 0; x < n; ++x) {
                bool floor = false;
                for (int y = 0; y < n; ++y) {
                    const bool wall = grid.solid({x, y, z});
                    floor |= wall;
                    if (floor && !wall) depth[index(x, y, z)] = 0;
                }
            }
        }
        glBindTexture(GL_TEXTURE_3D, depth_);
        glTexImage3D(GL_TEXTURE_3D, 0, GL_R16F, n, n, n, 0, GL_RED, GL_BYTE, depth.data());
        glTexParameteri(GL_TEXTURE_3D, GL_TEXTURE_MAX_LEVEL, 0);
    }

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
