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

GlObject make_volume(GLint format, int n)
{
    GlObject texture = make_texture(), framebuffer = make_framebuffer();
    glBindTexture(GL_TEXTURE_3D, texture);
    glTexImage3D(GL_TEXTURE_3D, 0, format, n, n, n, 0, GL_RGBA, GL_FLOAT, nullptr);
    check_memory("the depths of snow", 4.0 * n * n * n);
    glTexParameteri(GL_TEXTURE_3D, GL_TEXTURE_MIN_FILTER, GL_LINEAR);
    for (const GLenum wrap : {GL_TEXTURE_WRAP_S, GL_TEXTURE_WRAP_T, GL_TEXTURE_WRAP_R})
        glTexParameteri(GL_TEXTURE_3D, wrap, GL_CLAMP_TO_EDGE);
    const GLfloat zero[4] = {};
    glBindFramebuffer(GL_FRAMEBUFFER, framebuffer);
    glFramebufferTexture(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, texture, 0);  // all layers
    check_framebuffer("a volume");
    glClearBufferfv(GL_COLOR, 0, zero);
    glBindFramebuffer(GL_FRAMEBUFFER, 0);
    return texture;
}

Columns::Columns(const SolidScene& solid, const SnowCover& cover)
    : solid_(solid), cover_(cover),
      settle_({{GL_COMPUTE_SHADER, "step06_accumulation/cover/settle.comp"}}),
      melt_({{GL_COMPUTE_SHADER, "step06_accumulation/cover/melt.comp"}}),
      measure_({{GL_COMPUTE_SHADER, "step06_accumulation/cover/depth.comp"}}),
      depth_(make_volume(GL_RG16F, solid.grid.resolution))
{
    const size_t row = size_t(solid.grid.resolution) / 32;  // words
    for (size_t word = 0; word < solid.grid.words.size(); ++word) {
        const int y = int(word / row) % solid.grid.resolution;
        if (solid.grid.words[word] != 0) scene_top_ = std::max(scene_top_, y + 1);
    }
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

void Columns::dispatch(Program& program, unsigned tick, int ticks) const
{
    program.use();
    program.set("scene_top", scene_top_);
    cover_.bind();
    dispatch_turns(program, solid_.grid.resolution, tick, ticks);
}

// A time step looks after one of every 8 x 8 columns. Four that follow each other lie 4 apart,
// where they are no neighbours yet: a frame that has made four steps looks after them at once.
void dispatch_turns(Program& program, int resolution, unsigned tick, int ticks)
{
    for (unsigned turn = tick - unsigned(ticks); turn != tick;) {
        const int four = int(turn % Columns::steps_per_round) / 4, one = int(turn % 4);
        const bool at_once = one == 0 && tick - turn >= 4;
        const int stride = at_once ? 4 : 8;
        program.set("first_x", four % 4 + 4 * (one % 2));
        program.set("first_z", four / 4 + 4 * (one / 2));
        program.set("stride", stride);
        const unsigned groups = unsigned(resolution / stride + 7) / 8;  // 8: local_size_x and _y
        // What came before has read what this writes, and written what this reads.
        glMemoryBarrier(GL_SHADER_STORAGE_BARRIER_BIT | GL_SHADER_IMAGE_ACCESS_BARRIER_BIT);
        glDispatchCompute(groups, groups, 1);
        turn += at_once ? 4 : 1;
    }
    glMemoryBarrier(GL_TEXTURE_FETCH_BARRIER_BIT);  // the picture looks depths up
}
