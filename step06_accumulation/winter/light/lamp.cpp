#include "step06_accumulation/winter/light/lamp.hpp"

Lamp::Lamp()
    : program_({{GL_VERTEX_SHADER, "step06_accumulation/winter/light/lamp.vert"},
                {GL_FRAGMENT_SHADER, "step06_accumulation/winter/light/lamp.frag"}}),
      halo_({{GL_VERTEX_SHADER, "step04_transform_feedback/full_screen.vert"},
             {GL_FRAGMENT_SHADER, "step06_accumulation/winter/light/halo.frag"}})
{}

void Lamp::draw(const snow::Light& light, const SolidScene& solid)
{
    glEnable(GL_POLYGON_OFFSET_FILL);
    glPolygonOffset(-1, -1);  // a little nearer: the two must not fight over pixels
    program_.use();
    program_.set("lamp_is_on", light.lamp_is_on);
    for (const Submesh& submesh : solid.scene.submeshes) {
        if (submesh.material.light == glm::vec3(0)) continue;
        program_.set("own_light", submesh.material.light);
        solid.mesh.draw(submesh);
    }
    glDisable(GL_POLYGON_OFFSET_FILL);
}

void Lamp::draw_halo(GLuint frame_depth)
{
    halo_.use();
    halo_.set_texture("frame_depth", FRAME_DEPTH_UNIT, GL_TEXTURE_2D, frame_depth);
    glDisable(GL_DEPTH_TEST);
    glEnable(GL_BLEND);
    glBlendFunc(GL_ONE, GL_ONE);
    glDepthMask(GL_FALSE);  // or it would read what it may write
    glBindVertexArray(vao_);
    glDrawArrays(GL_TRIANGLES, 0, 3);
    glDepthMask(GL_TRUE);
    glBlendFunc(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA);
    glDisable(GL_BLEND);
    glEnable(GL_DEPTH_TEST);
}
