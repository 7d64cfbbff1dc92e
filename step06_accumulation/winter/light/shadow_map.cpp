#include "step06_accumulation/winter/light/shadow_map.hpp"

ShadowMap::ShadowMap()
    : depth_(make_texture()), framebuffer_(make_framebuffer()),
      program_({{GL_VERTEX_SHADER, "step06_accumulation/winter/light/shadow.vert"},
                {GL_FRAGMENT_SHADER, "step06_accumulation/winter/light/shadow.frag"}})
{
    glBindTexture(GL_TEXTURE_2D, depth_);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_COMPARE_MODE, GL_COMPARE_REF_TO_TEXTURE);
    // Beside the map there is no scene and no shadow.
    const float farthest[4] = {1, 1, 1, 1};
    glTexParameterfv(GL_TEXTURE_2D, GL_TEXTURE_BORDER_COLOR, farthest);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_S, GL_CLAMP_TO_BORDER);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_T, GL_CLAMP_TO_BORDER);

    glBindFramebuffer(GL_FRAMEBUFFER, framebuffer_);
    glFramebufferTexture2D(GL_FRAMEBUFFER, GL_DEPTH_ATTACHMENT, GL_TEXTURE_2D, depth_, 0);
    glDrawBuffer(GL_NONE);
    glReadBuffer(GL_NONE);
    glBindFramebuffer(GL_FRAMEBUFFER, 0);  // it is complete when it is first drawn to
}

void ShadowMap::update(glm::vec3 to_sun, const SolidScene& solid, bool soft, bool wide)
{
    // A lookup compares a depth with those of the four nearest texels and blends the results, or
    // with one.
    glBindTexture(GL_TEXTURE_2D, depth_);
    for (const GLenum filter : {GL_TEXTURE_MIN_FILTER, GL_TEXTURE_MAG_FILTER})
        glTexParameteri(GL_TEXTURE_2D, filter, soft ? GL_LINEAR : GL_NEAREST);
    const GLsizei texels = wide ? 2048 : 1024;  // more of a small map fits into the cache
    if (texels != texels_) {
        texels_ = texels;
        glTexImage2D(GL_TEXTURE_2D, 0, GL_DEPTH_COMPONENT16, texels, texels, 0, GL_DEPTH_COMPONENT,
                     GL_UNSIGNED_SHORT, nullptr);
        drawn_for_ = {};
    }
    if (to_sun == drawn_for_) return;
    drawn_for_ = to_sun;
    glBindFramebuffer(GL_FRAMEBUFFER, framebuffer_);
    check_framebuffer("the shadow map");
    glViewport(0, 0, texels, texels);
    glClear(GL_DEPTH_BUFFER_BIT);
    // A texel is as deep as its middle: push all surfaces back by as much as they fall off in a
    // texel, or they would shadow themselves in stripes.
    glEnable(GL_POLYGON_OFFSET_FILL);
    glPolygonOffset(2, 2);
    program_.use();
    solid.draw(program_);
    glDisable(GL_POLYGON_OFFSET_FILL);
}
