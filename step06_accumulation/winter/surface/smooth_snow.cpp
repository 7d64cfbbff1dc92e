#include "step06_accumulation/winter/surface/smooth_snow.hpp"

SmoothSnow::SmoothSnow(const Columns& columns, int resolution)
    : columns_(columns),
      program_({{GL_COMPUTE_SHADER, "step06_accumulation/winter/surface/smooth.comp"}}),
      texture_(make_volume(GL_RGBA8, resolution))
{}

void SmoothSnow::update(unsigned tick, int ticks)
{
    glBindImageTexture(DEPTH_IMAGE, columns_.depth(), 0, GL_TRUE, 0, GL_READ_ONLY, GL_RG16F);
    glBindImageTexture(SNOW_IMAGE, texture_, 0, GL_TRUE, 0, GL_WRITE_ONLY, GL_RGBA8);
    columns_.dispatch(program_, tick, ticks);
}
