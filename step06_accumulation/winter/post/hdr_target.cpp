#include "step06_accumulation/winter/post/hdr_target.hpp"

#include <algorithm>

namespace {

GlObject make_renderbuffer_of(GLenum format, glm::ivec2 size, int samples)
{
    GlObject made(glGenRenderbuffers, glDeleteRenderbuffers);
    glBindRenderbuffer(GL_RENDERBUFFER, made);
    glRenderbufferStorageMultisample(GL_RENDERBUFFER, samples > 1 ? samples : 0, format, size.x,
                                     size.y);
    return made;
}

void attach_depth(GLuint depth)
{
    glFramebufferRenderbuffer(GL_FRAMEBUFFER, GL_DEPTH_ATTACHMENT, GL_RENDERBUFFER, depth);
}

}  // namespace

void HdrTarget::begin(glm::ivec2 size, bool multisample, glm::vec3 background)
{
    GLint most = 1;
    glGetIntegerv(GL_MAX_SAMPLES, &most);
    const int samples = multisample ? std::min(4, most) : 1;
    if (size != size_ || samples != samples_) {
        size_ = size;
        samples_ = samples;
        allocate();
    }
    glBindFramebuffer(GL_FRAMEBUFFER, samples > 1 ? samples_framebuffer_ : framebuffer_);
    const GLfloat farthest = 1;
    glClearBufferfv(GL_COLOR, 0, &glm::vec4(background, 1)[0]);
    glClearBufferfv(GL_DEPTH, 0, &farthest);
}

void HdrTarget::resolve() const
{
    if (samples_ == 1) return;
    glBindFramebuffer(GL_READ_FRAMEBUFFER, samples_framebuffer_);
    glBindFramebuffer(GL_DRAW_FRAMEBUFFER, framebuffer_);
    glBlitFramebuffer(0, 0, size_.x, size_.y, 0, 0, size_.x, size_.y,
                      GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT, GL_NEAREST);
    glBindFramebuffer(GL_FRAMEBUFFER, framebuffer_);
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
    depth_ = make_renderbuffer_of(GL_DEPTH_COMPONENT24, size_, 1);
    framebuffer_ = make_framebuffer();
    glBindFramebuffer(GL_FRAMEBUFFER, framebuffer_);
    glFramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D, colour_, 0);
    attach_depth(depth_);
    check_framebuffer("the frame");
    if (samples_ > 1) {
        samples_colour_ = make_renderbuffer_of(GL_RGBA16F, size_, samples_);
        samples_depth_ = make_renderbuffer_of(GL_DEPTH_COMPONENT24, size_, samples_);
        samples_framebuffer_ = make_framebuffer();
        glBindFramebuffer(GL_FRAMEBUFFER, samples_framebuffer_);
        glFramebufferRenderbuffer(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_RENDERBUFFER,
                                  samples_colour_);
        attach_depth(samples_depth_);
        check_framebuffer("the samples of the frame");
    }
    check_memory("the frame", 12.0 * (samples_ > 1 ? 1 + samples_ : 1) * size_.x * size_.y);
}
