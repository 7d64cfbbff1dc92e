#include "step06_accumulation/heightmap/height_map.hpp"

#include "step06_accumulation/cover/columns.hpp"

HeightMap::HeightMap(const SolidScene& solid, const SnowCover& cover)
    : cover_(cover), resolution_(solid.grid.resolution),
      settle_({{GL_COMPUTE_SHADER, "step06_accumulation/heightmap/settle.comp"}})
{
    glBindTexture(GL_TEXTURE_2D, heights_);
    glTexImage2D(GL_TEXTURE_2D, 0, GL_DEPTH_COMPONENT32F, resolution_, resolution_, 0,
                 GL_DEPTH_COMPONENT, GL_FLOAT, nullptr);
    check_memory("the height map", 4.0 * resolution_ * resolution_);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
    const GlObject framebuffer = make_framebuffer();
    glBindFramebuffer(GL_FRAMEBUFFER, framebuffer);
    glFramebufferTexture(GL_FRAMEBUFFER, GL_DEPTH_ATTACHMENT, heights_, 0);
    glDrawBuffer(GL_NONE);
    check_framebuffer("the height map");
    const Program from_above({{GL_VERTEX_SHADER, "step06_accumulation/heightmap/from_above.vert"}});
    from_above.use();
    solid.bind();
    glViewport(0, 0, resolution_, resolution_);
    glEnable(GL_DEPTH_TEST);
    glClear(GL_DEPTH_BUFFER_BIT);
    SceneMesh(solid.obstacle()).draw();
    glBindFramebuffer(GL_FRAMEBUFFER, 0);

    glBindTexture(GL_TEXTURE_BUFFER, lying_);
    glTexBuffer(GL_TEXTURE_BUFFER, GL_R32UI, cover.buffer());
}

void HeightMap::bind() const
{
    bind_texture(HEIGHTS_UNIT, GL_TEXTURE_2D, heights_);
    bind_texture(DEPTH_UNIT, GL_TEXTURE_BUFFER, lying_);
}

void HeightMap::settle(unsigned tick, int ticks)
{
    settle_.use();
    cover_.bind();
    bind();
    dispatch_turns(settle_, resolution_, tick, ticks);
}
