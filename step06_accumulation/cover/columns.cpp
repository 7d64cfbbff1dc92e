#include "step06_accumulation/cover/columns.hpp"

#include <algorithm>

std::vector<snow::Parameter> CoverSettings::parameters()
{
    return snow::under("Snow that lies",
                       {{"settling", "slides", "on/off", 0, 1,
                         "snow steeper than its angle of repose slides", &settling},
                        {"melting", "melts", "on/off", 0, 1,
                         "snow melts where it is warmer than 0 degrees", &melting}});
}

Columns::Columns(const SolidScene& solid, const SnowCover& cover)
    : solid_(solid), cover_(cover),
      settle_({{GL_COMPUTE_SHADER, "step06_accumulation/cover/settle.comp"}}),
      melt_({{GL_COMPUTE_SHADER, "step06_accumulation/cover/melt.comp"}}),
      measure_({{GL_COMPUTE_SHADER, "step06_accumulation/cover/depth.comp"}})
{
    clear_depth();
}

void Columns::melt(unsigned tick, int ticks, const snow::Weather& weather)
{
    if (weather.temperature > 0) dispatch(melt_, tick, ticks);
}

void Columns::measure(unsigned tick, int ticks)
{
    glBindImageTexture(DEPTH_IMAGE, depth_, 0, GL_TRUE, 0, GL_READ_WRITE, GL_RG16F);
    dispatch(measure_, tick, ticks);
}

// No snow anywhere; and none can ever be within walls, or where there is nothing to lie on. Finds
// scene_top_, too.
void Columns::clear_depth()
{
    const int n = solid_.grid.resolution;
    std::vector<GLubyte> depth(2 * size_t(n) * size_t(n) * size_t(n));  // see snow_depth.glsl
    for (int z = 0; z < n; ++z) {
        for (int x = 0; x < n; ++x) {
            bool floor = false;
            for (int y = 0; y < n; ++y) {
                const bool wall = y == 0 || solid_.grid.solid({x, y, z});  // as in_base has it
                floor |= wall;
                if (wall) scene_top_ = std::max(scene_top_, y + 1);
                if (floor && !wall)
                    depth[2 * ((size_t(z) * size_t(n) + size_t(y)) * size_t(n) + size_t(x)) + 1] =
                        255;
            }
        }
    }
    glBindTexture(GL_TEXTURE_3D, depth_);
    glTexImage3D(GL_TEXTURE_3D, 0, GL_RG16F, n, n, n, 0, GL_RG, GL_UNSIGNED_BYTE, depth.data());
    check_memory("the depths of snow", 2.0 * double(depth.size()));
    glTexParameteri(GL_TEXTURE_3D, GL_TEXTURE_MIN_FILTER, GL_LINEAR);
    for (const GLenum wrap : {GL_TEXTURE_WRAP_S, GL_TEXTURE_WRAP_T, GL_TEXTURE_WRAP_R}) {
        glTexParameteri(GL_TEXTURE_3D, wrap, GL_CLAMP_TO_EDGE);
    }
}

void Columns::dispatch(Program& program, unsigned tick, int ticks) const
{
    const int n = solid_.grid.resolution;
    program.use();
    program.set("scene_top", scene_top_);
    cover_.bind();
    // Of every 8 x 8 columns one a time step. Four that follow each other lie 4 apart, where they
    // are no neighbours yet: a frame that has made four steps looks after them at once.
    for (unsigned turn = tick - unsigned(ticks); turn != tick;) {
        const int four = int(turn % steps_per_round) / 4, one = int(turn % 4);
        const bool at_once = one == 0 && tick - turn >= 4;
        const int stride = at_once ? 4 : 8;
        program.set("first_x", four % 4 + 4 * (one % 2));
        program.set("first_z", four / 4 + 4 * (one / 2));
        program.set("stride", stride);
        const unsigned groups = unsigned(n / stride + 7) / 8;  // 8: local_size_x and _y
        // What came before has read what this writes, and written what this reads.
        glMemoryBarrier(GL_SHADER_STORAGE_BARRIER_BIT | GL_SHADER_IMAGE_ACCESS_BARRIER_BIT);
        glDispatchCompute(groups, groups, 1);
        turn += at_once ? 4 : 1;
    }
    glMemoryBarrier(GL_TEXTURE_FETCH_BARRIER_BIT);  // the picture looks depths up
}
