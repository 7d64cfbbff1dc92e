#include "step06_accumulation/winter/light/sky.hpp"

Sky::Sky()
    : day_({{GL_VERTEX_SHADER, "step06_accumulation/winter/light/sky.vert"},
            {GL_FRAGMENT_SHADER, "step06_accumulation/winter/light/sky.frag"}}),
      night_({{GL_VERTEX_SHADER, "step06_accumulation/winter/light/sky.vert"},
              {GL_FRAGMENT_SHADER, "step06_accumulation/winter/light/night.frag"}})
{}

std::vector<snow::Parameter> Sky::parameters()
{
    return {{"sky", "sky", "on/off", 0, 1, "the sky behind the scene", &sky}};
}

void Sky::draw(const snow::Light& light)
{
    (light.stars > 0 ? night_ : day_).use();
    glBindVertexArray(vao_);
    glDepthRange(1, 1);  // as far as can be: it is seen where nothing else was drawn
    glDepthFunc(GL_LEQUAL);
    glDrawArrays(GL_TRIANGLES, 0, 40 * 24 * 6);  // squares across and up, see sky.vert
    glDepthFunc(GL_LESS);
    glDepthRange(0, 1);
}
