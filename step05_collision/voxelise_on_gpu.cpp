#include "step05_collision/voxelise_on_gpu.hpp"

#include <stdexcept>

#include "common/harness/driver.hpp"
#include "common/program.hpp"
#include "common/uniform_block.hpp"
#include "step05_collision/scene_mesh.hpp"

VoxelGrid voxelise_on_gpu(const Scene& scene, int resolution)
{
    if (!GLEW_VERSION_4_2) {
        throw std::runtime_error("--voxeliser gpu needs OpenGL 4.2, which " + renderer_name() +
                                 " lacks: use --voxeliser cpu");
    }
    VoxelGrid grid = place_grid(scene, resolution);
    const GlObject words = upload_voxels(grid);  // all empty
    Program program({{GL_VERTEX_SHADER, "step05_collision/voxelise.vert"},
                     {GL_GEOMETRY_SHADER, "step05_collision/voxelise.geom"},
                     {GL_FRAGMENT_SHADER, "step05_collision/voxelise.frag"}});
    const SceneMesh mesh(scene);

    // As many pixels as columns. What is drawn is not seen, but there must be something to draw on.
    const GlObject nothing = make_texture(), framebuffer = make_framebuffer();
    glBindTexture(GL_TEXTURE_2D, nothing);
    glTexImage2D(GL_TEXTURE_2D, 0, GL_R8, resolution, resolution, 0, GL_RED, GL_UNSIGNED_BYTE,
                 nullptr);
    glBindFramebuffer(GL_FRAMEBUFFER, framebuffer);
    glFramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D, nothing, 0);
    glViewport(0, 0, resolution, resolution);
    glColorMask(GL_FALSE, GL_FALSE, GL_FALSE, GL_FALSE);
    program.use();
    UniformBlock<snow::Grid> block;
    block.update(GRID_BLOCK, {grid.origin, grid.cell_size, grid.resolution, 0, 0, 0});
    // All layers are bound: a voxel may lie in any.
    glBindImageTexture(VOXELS_IMAGE, words, 0, GL_TRUE, 0, GL_READ_WRITE, GL_R32UI);
    mesh.draw();
    glColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
    glBindFramebuffer(GL_FRAMEBUFFER, 0);

    glMemoryBarrier(GL_TEXTURE_UPDATE_BARRIER_BIT);  // what is read next sees every voxel
    glBindTexture(GL_TEXTURE_3D, words);
    glGetTexImage(GL_TEXTURE_3D, 0, GL_RED_INTEGER, GL_UNSIGNED_INT, grid.words.data());
    return grid;
}
