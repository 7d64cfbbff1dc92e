#include "step06_accumulation/winter/post/hdr_target.hpp"

void HdrTarget::begin(glm::ivec2 size, bool multisample, glm::vec3 background)
{
    if (size != size_ || multisample != multisample_) {
        size_ = size;
        multisample_ = multisample;
        allocate();
    }
    glBindFramebuffer(GL_FRAMEBUFFER, multisample ? samples_framebuffer_ : framebuffer_);
    const GLfloat farthest = 1;
    glClearBufferfv(GL_COLOR, 0, &glm::vec4(background, 1)[0]);
    glClearBufferfv(GL_DEPTH, 0, &farthest);
}

void HdrTarget::resolve() const
{
    if (!multisample_) return;
    glBindFramebuffer(GL_READ_FRAMEBUFFER, samples_framebuffer_);
    glBindFramebuffer(GL_DRAW_FRAMEBUFFER, framebuffer_);
    glBlitFramebuffer(0, 0, size_.x, size_.y, 0, 0, size_.x, size_.y,
                      GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT, GL_NEAREST);
    glBindFramebuffer(GL_FRAMEBUFFER, framebuffer_);
}

// To the framebuffer that is bound.
void HdrTarget::add_renderbuffer(GLenum attachment, GLenum format, int samples, GlObject& buffer)
{
    buffer = GlObject(glGenRenderbuffers, glDeleteRenderbuffers);
    glBindRenderbuffer(GL_RENDERBUFFER, buffer);
    glRenderbufferStorageMultisample(GL_RENDERBUFFER, samples, format, size_.x, size_.y);
    glFramebufferRenderbuffer(GL_FRAMEBUFFER, attachment, GL_RENDERBUFFER, buffer);
}

void HdrTarget::allocate()
{
    colour_ = make_texture();
    glBindTexture(GL_TEXTURE_2D, colour_);
    glTexImage2D(GL_TEXTURE_2D, 0, GL_RGBA16F, size_.x, size_.y, 0, GL_RGBA, GL_FLOAT, nullptr);
    glGenerateMipmap(GL_TEXTURE_2D);  // a texture that lacks some cannot be read
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_LINEAR_MIPMAP_NEAREST);
    for (const GLenum wrap : {GL_TEXTURE_WRAP_S, GL_TEXTURE_WRAP_T})
        glTexParameteri(GL_TEXTURE_2D, wrap, GL_CLAMP_TO_EDGE);
    framebuffer_ = make_framebuffer();
    glBindFramebuffer(GL_FRAMEBUFFER, framebuffer_);
    glFramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D, colour_, 0);
    add_renderbuffer(GL_DEPTH_ATTACHMENT, GL_DEPTH_COMPONENT24, 0, depth_);
    check_framebuffer("the frame");
    if (multisample_) {
        constexpr int samples = 4;  // every card has as many
        samples_framebuffer_ = make_framebuffer();
        glBindFramebuffer(GL_FRAMEBUFFER, samples_framebuffer_);
        add_renderbuffer(GL_COLOR_ATTACHMENT0, GL_RGBA16F, samples, samples_colour_);
        add_renderbuffer(GL_DEPTH_ATTACHMENT, GL_DEPTH_COMPONENT24, samples, samples_depth_);
        check_framebuffer("the samples of the frame");
    }
    check_memory("the frame", 12.0 * (multisample_ ? 5 : 1) * size_.x * size_.y);
}
