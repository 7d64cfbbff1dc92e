#include "step06_accumulation/winter/wind/wind_arrows.hpp"

WindArrows::WindArrows()
    : program_({{GL_VERTEX_SHADER, "step06_accumulation/winter/wind/arrow.vert"},
                {GL_FRAGMENT_SHADER, "step06_accumulation/winter/wind/arrow.frag"}})
{}

void WindArrows::draw(const WindField& wind, const SolidScene& solid, const snow::Weather& weather,
                      unsigned tick)
{
    Program& program = wind.use(program_, weather);
    set_voxels(program, solid);
    program.set("tick", tick);
    glBindVertexArray(vao_);
    glDrawArraysInstanced(GL_TRIANGLES, 0, 9, 16 * 16 * 4);  // corners, arrows: see arrow.vert
}
