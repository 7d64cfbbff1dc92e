#include "step06_accumulation/winter/post/bloom.hpp"

#include <utility>

Bloom::Bloom()
    : shrink_({{GL_VERTEX_SHADER, "step04_transform_feedback/full_screen.vert"},
               {GL_FRAGMENT_SHADER, "step06_accumulation/winter/post/shrink.frag"}}),
      grow_({{GL_VERTEX_SHADER, "step04_transform_feedback/full_screen.vert"},
             {GL_FRAGMENT_SHADER, "step06_accumulation/winter/post/grow.frag"}})
{}

void Bloom::update(const HdrTarget& frame)
{
    if (frame.size() != size_) allocate(frame.size());
    const auto draw = [](Program& program, GLuint from, const Level& to) {
        program.use();
        program.set("pixel", 1.0f / glm::vec2(to.size));
        bind_texture(GLOW_UNIT, GL_TEXTURE_2D, from);
        glBindFramebuffer(GL_FRAMEBUFFER, to.framebuffer);
        glViewport(0, 0, to.size.x, to.size.y);
        glDrawArrays(GL_TRIANGLES, 0, 3);
    };
    for (size_t i = 0; i < levels_.size(); ++i)
        draw(shrink_, i == 0 ? frame.colour() : GLuint(levels_[i - 1].colour), levels_[i]);
    // Each becomes the mean of itself and of what is wider.
    glEnable(GL_BLEND);
    for (size_t i = levels_.size() - 1; i > 0; --i) draw(grow_, levels_[i].colour, levels_[i - 1]);
    glDisable(GL_BLEND);
    glViewport(0, 0, size_.x, size_.y);
}

void Bloom::allocate(glm::ivec2 size)
{
    constexpr int most_levels = 5;
    size_ = size;
    levels_.clear();
    for (size = glm::max(size / 4, 1); levels_.size() < most_levels; size = glm::max(size / 2, 1)) {
        Level level{make_target_texture(size), make_framebuffer(), size};
        glBindFramebuffer(GL_FRAMEBUFFER, level.framebuffer);
        glFramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D, level.colour,
                               0);
        check_framebuffer("the glow");
        levels_.push_back(std::move(level));
    }
}
