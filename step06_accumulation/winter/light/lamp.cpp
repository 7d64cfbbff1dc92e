#include "step06_accumulation/winter/light/lamp.hpp"

Lamp::Lamp()
    : program_({{GL_VERTEX_SHADER, "step06_accumulation/winter/light/lamp.vert"},
                {GL_FRAGMENT_SHADER, "step06_accumulation/winter/light/lamp.frag"}})
{}

void Lamp::draw(const snow::Light& light, const SolidScene& solid)
{
    if (light.lamp_is_on == 0) return;
    glEnable(GL_POLYGON_OFFSET_FILL);
    glPolygonOffset(-1, -1);  // a little nearer: the two must not fight over pixels
    program_.use();
    for (const Submesh& submesh : solid.scene.submeshes) {
        if (submesh.material.light == glm::vec3(0)) continue;
        program_.set("own_light", submesh.material.light);
        solid.mesh.draw(submesh);
    }
    glDisable(GL_POLYGON_OFFSET_FILL);
}
