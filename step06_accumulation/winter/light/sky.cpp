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
    Program& program = light.stars > 0 ? night_ : day_;
    program.use();
    const glm::ivec2 squares(40, 24);  // see sky.vert
    program.set("squares", glm::vec2(squares));
    glBindVertexArray(vao_);
    glDepthRange(1, 1);  // as far as can be: it is seen where nothing else was drawn
    glDepthFunc(GL_LEQUAL);
    glDrawArrays(GL_TRIANGLES, 0, 6 * squares.x * squares.y);
    glDepthFunc(GL_LESS);
    glDepthRange(0, 1);
}
