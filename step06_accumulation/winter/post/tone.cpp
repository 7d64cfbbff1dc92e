#include "step06_accumulation/winter/post/tone.hpp"

Tone::Tone()
    : plain_({{GL_VERTEX_SHADER, "step04_transform_feedback/full_screen.vert"},
              {GL_FRAGMENT_SHADER, "step06_accumulation/winter/post/tone.frag"}}),
      glowing_({{GL_VERTEX_SHADER, "step04_transform_feedback/full_screen.vert"},
                {GL_FRAGMENT_SHADER, "step06_accumulation/winter/post/tone_with_bloom.frag"}})
{}

std::vector<snow::Parameter> Tone::parameters()
{
    return {{"exposure", "exposure", "", 0.1f, 10, "of the picture", &exposure}};
}

void Tone::draw(const LinearFrame& frame, const Bloom* bloom)
{
    Program& program = bloom != nullptr ? glowing_ : plain_;
    program.use();
    program.set("exposure", exposure);
    program.set_texture("frame", FRAME_UNIT, GL_TEXTURE_2D, frame.colour());
    if (bloom != nullptr) {
        program.set("part", Bloom::bloom);
        program.set_texture("glow", GLOW_UNIT, GL_TEXTURE_2D, bloom->texture());
    }
    glDisable(GL_DEPTH_TEST);
    glBindVertexArray(vao_);
    glDrawArrays(GL_TRIANGLES, 0, 3);
    glEnable(GL_DEPTH_TEST);
}
