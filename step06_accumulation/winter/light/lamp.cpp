#include "step06_accumulation/winter/light/lamp.hpp"

Lamp::Lamp(const Scene& scene)
    : glass_(scene.lamps),
      program_({{GL_VERTEX_SHADER, "step06_accumulation/winter/light/lamp.vert"},
                {GL_FRAGMENT_SHADER, "step06_accumulation/winter/light/lamp.frag"}})
{}

void Lamp::draw(const snow::Light& light)
{
    if (light.lamp_is_on == 0) return;
    glEnable(GL_POLYGON_OFFSET_FILL);
    glPolygonOffset(-1, -1);  // a little nearer: the two must not fight over pixels
    program_.use();
    glass_.draw();
    glDisable(GL_POLYGON_OFFSET_FILL);
}
