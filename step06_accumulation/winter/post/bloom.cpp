#include "step06_accumulation/winter/post/bloom.hpp"

Bloom::Bloom()
    : shrink_({{GL_VERTEX_SHADER, "step04_transform_feedback/full_screen.vert"},
               {GL_FRAGMENT_SHADER, "step06_accumulation/winter/post/shrink.frag"}}),
      grow_({{GL_VERTEX_SHADER, "step04_transform_feedback/full_screen.vert"},
             {GL_FRAGMENT_SHADER, "step06_accumulation/winter/post/grow.frag"}})
{}

std::vector<snow::Parameter> Bloom::parameters()
{
    return {{"bloom", "glow", "", 0, 0.5f, "part of the light that spreads around what is bright",
             &bloom, 0, "", true}};
}

void Bloom::update(const LinearFrame& frame)
{
    if (frame.size() != size_) allocate(frame.size());
    const auto draw = [](Program& program, const char* from, GLuint source, const Level& to) {
        program.use();
        program.set_texture(from, GLOW_UNIT, GL_TEXTURE_2D, source);
        program.set("pixel", 1.0f / glm::vec2(to.size));
        glBindFramebuffer(GL_FRAMEBUFFER, to.framebuffer);
        glViewport(0, 0, to.size.x, to.size.y);
        glDrawArrays(GL_TRIANGLES, 0, 3);
    };
    glDisable(GL_DEPTH_TEST);
    glBindVertexArray(vao_);
    for (size_t i = 0; i < levels_.size(); ++i)
        draw(shrink_, "larger", i == 0 ? frame.colour() : GLuint(levels_[i - 1].colour),
             levels_[i]);
    // Each becomes the mean of itself and of what is wider.
    glEnable(GL_BLEND);
    glBlendFunc(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA);
    for (size_t i = levels_.size() - 1; i > 0; --i)
        draw(grow_, "smaller", levels_[i].colour, levels_[i - 1]);
    glDisable(GL_BLEND);
    glEnable(GL_DEPTH_TEST);
    glViewport(0, 0, size_.x, size_.y);
}

void Bloom::allocate(glm::ivec2 size)
{
    constexpr int most_levels = 5;
    size_ = size;
    levels_.clear();
    for (size = glm::max(size / 4, 1); levels_.size() < most_levels; size = glm::max(size / 2, 1)) {
        Level level{make_texture(), make_framebuffer(), size};
        glBindTexture(GL_TEXTURE_2D, level.colour);
        glTexImage2D(GL_TEXTURE_2D, 0, GL_RGBA16F, size.x, size.y, 0, GL_RGBA, GL_FLOAT, nullptr);
        for (const GLenum filter : {GL_TEXTURE_MIN_FILTER, GL_TEXTURE_MAG_FILTER})
            glTexParameteri(GL_TEXTURE_2D, filter, GL_LINEAR);
        for (const GLenum wrap : {GL_TEXTURE_WRAP_S, GL_TEXTURE_WRAP_T})
            glTexParameteri(GL_TEXTURE_2D, wrap, GL_CLAMP_TO_EDGE);
        glBindFramebuffer(GL_FRAMEBUFFER, level.framebuffer);
        glFramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D, level.colour,
                               0);
        levels_.push_back(std::move(level));
    }
}
