#include "step06_accumulation/winter/surface/smooth_snow.hpp"

#include <vector>

SmoothSnow::SmoothSnow(const Columns& columns, int resolution)
    : columns_(columns),
      program_({{GL_COMPUTE_SHADER, "step06_accumulation/winter/surface/smooth.comp"}}),
      texture_(make_texture())
{
    const std::vector<GLubyte> unknown(4 * size_t(resolution) * size_t(resolution) *
                                       size_t(resolution));
    glBindTexture(GL_TEXTURE_3D, texture_);
    glTexImage3D(GL_TEXTURE_3D, 0, GL_RGBA8, resolution, resolution, resolution, 0, GL_RGBA,
                 GL_UNSIGNED_BYTE, unknown.data());
    check_memory("the snow as it looks", double(unknown.size()));
    glTexParameteri(GL_TEXTURE_3D, GL_TEXTURE_MIN_FILTER, GL_LINEAR);
    for (const GLenum wrap : {GL_TEXTURE_WRAP_S, GL_TEXTURE_WRAP_T, GL_TEXTURE_WRAP_R})
        glTexParameteri(GL_TEXTURE_3D, wrap, GL_CLAMP_TO_EDGE);
    update(Columns::steps_per_round, Columns::steps_per_round);
}

void SmoothSnow::update(unsigned tick, int ticks)
{
    glBindImageTexture(DEPTH_IMAGE, columns_.depth(), 0, GL_TRUE, 0, GL_READ_ONLY, GL_RG16F);
    glBindImageTexture(SNOW_IMAGE, texture_, 0, GL_TRUE, 0, GL_WRITE_ONLY, GL_RGBA8);
    columns_.dispatch(program_, tick, ticks);
}
