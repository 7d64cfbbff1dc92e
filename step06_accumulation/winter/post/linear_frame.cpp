#include "step06_accumulation/winter/post/linear_frame.hpp"

#include <algorithm>

std::vector<snow::Parameter> LinearFrame::parameters()
{
    return {{"multisample", "smooth edges", "on/off", 0, 1, "four samples a pixel along edges",
             &multisample, 0, "", true}};
}

void LinearFrame::begin(glm::ivec2 size, glm::vec3 background)
{
    GLint most = 1;
    glGetIntegerv(GL_MAX_SAMPLES, &most);
    const int samples = multisample ? std::min(4, most) : 1;
    if (size != size_ || samples != samples_) {
        size_ = size;
        allocate(samples);
    }
    glBindFramebuffer(GL_FRAMEBUFFER, samples > 1 ? many_framebuffer_ : framebuffer_);
    const GLfloat farthest = 1;
    glClearBufferfv(GL_COLOR, 0, &glm::vec4(background, 1)[0]);
    glClearBufferfv(GL_DEPTH, 0, &farthest);
}

void LinearFrame::end_edges()
{
    if (samples_ == 1) return;
    glBindFramebuffer(GL_READ_FRAMEBUFFER, many_framebuffer_);
    glBindFramebuffer(GL_DRAW_FRAMEBUFFER, framebuffer_);
    glBlitFramebuffer(0, 0, size_.x, size_.y, 0, 0, size_.x, size_.y,
                      GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT, GL_NEAREST);
    glBindFramebuffer(GL_FRAMEBUFFER, framebuffer_);
}

void LinearFrame::detach_depth() const
{
    glBindFramebuffer(GL_FRAMEBUFFER, colours_only_);
}

void LinearFrame::attach_depth() const
{
    glBindFramebuffer(GL_FRAMEBUFFER, framebuffer_);
}

void LinearFrame::end() const
{
    glBindFramebuffer(GL_FRAMEBUFFER, 0);
}

void LinearFrame::allocate(int samples)
{
    samples_ = samples;
    const auto texture = [this](GLint kept_as, GLenum channels, GLenum type) {
        GlObject made = make_texture();
        glBindTexture(GL_TEXTURE_2D, made);
        glTexImage2D(GL_TEXTURE_2D, 0, kept_as, size_.x, size_.y, 0, channels, type, nullptr);
        for (const GLenum filter : {GL_TEXTURE_MIN_FILTER, GL_TEXTURE_MAG_FILTER})
            glTexParameteri(GL_TEXTURE_2D, filter, GL_LINEAR);
        for (const GLenum wrap : {GL_TEXTURE_WRAP_S, GL_TEXTURE_WRAP_T})
            glTexParameteri(GL_TEXTURE_2D, wrap, GL_CLAMP_TO_EDGE);
        return made;
    };
    colour_ = texture(GL_RGBA16F, GL_RGBA, GL_FLOAT);
    depth_ = texture(GL_DEPTH_COMPONENT24, GL_DEPTH_COMPONENT, GL_UNSIGNED_INT);
    colours_only_ = make_framebuffer();
    framebuffer_ = make_framebuffer();
    for (const GLuint framebuffer : {GLuint(colours_only_), GLuint(framebuffer_)}) {
        glBindFramebuffer(GL_FRAMEBUFFER, framebuffer);
        glFramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D, colour_, 0);
    }
    glFramebufferTexture2D(GL_FRAMEBUFFER, GL_DEPTH_ATTACHMENT, GL_TEXTURE_2D, depth_, 0);
    if (samples > 1) {
        many_colours_ = make_renderbuffer();
        glBindRenderbuffer(GL_RENDERBUFFER, many_colours_);
        glRenderbufferStorageMultisample(GL_RENDERBUFFER, samples, GL_RGBA16F, size_.x, size_.y);
        many_depths_ = make_renderbuffer();
        glBindRenderbuffer(GL_RENDERBUFFER, many_depths_);
        glRenderbufferStorageMultisample(GL_RENDERBUFFER, samples, GL_DEPTH_COMPONENT24, size_.x,
                                         size_.y);
        many_framebuffer_ = make_framebuffer();
        glBindFramebuffer(GL_FRAMEBUFFER, many_framebuffer_);
        glFramebufferRenderbuffer(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_RENDERBUFFER,
                                  many_colours_);
        glFramebufferRenderbuffer(GL_FRAMEBUFFER, GL_DEPTH_ATTACHMENT, GL_RENDERBUFFER,
                                  many_depths_);
    }
    check_memory("the frame", (12.0 + (samples > 1 ? 12.0 * samples : 0)) * size_.x * size_.y);
}
