// The wind as arrows, one in every few cells of its field.
#pragma once

#include <GL/glew.h>

#include "common/program.hpp"
#include "step05_collision/scene_collider.hpp"
#include "step05_collision/solid_scene.hpp"
#include "step06_accumulation/wind_field.hpp"

class WindArrows {
public:
    // step: physics steps made since the first flake.
    void draw(const WindField& wind, const SolidScene& solid, const Options& options, unsigned step)
    {
        program_.use();
        set_voxels(program_, solid.grid, solid.voxels);
        wind.set(program_, options);
        program_.set("step_number", step);
        glBindVertexArray(vao_);
        glDrawArraysInstanced(GL_TRIANGLES, 0, 9, 16 * 16 * 4);  // corners, arrows: see arrow.vert
    }

private:
    Program program_{{{GL_VERTEX_SHADER, "step06_accumulation/arrow.vert"},
                      {GL_FRAGMENT_SHADER, "step06_accumulation/arrow.frag"}}};
    GlObject vao_ = make_vertex_array();  // of nothing: the shader knows its corners
};
