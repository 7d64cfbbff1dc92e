#include "step05_collision/solid_scene.hpp"

#include <chrono>
#include <iostream>

#include "common/window.hpp"
#include "step05_collision/ground.hpp"
#include "step05_collision/voxelise_on_gpu.hpp"

namespace {

std::optional<Scene> load_collision(const Options& options, const Scene& drawn)
{
    if (options.collision.empty()) return {};
    const bool drawn_is_empty = drawn.vertices.empty();
    return load_scene(options.collision, options.up, drawn_is_empty ? nullptr : &drawn.placement,
                      options.metres);
}

VoxelGrid make_grid(const Options& options, const Scene& obstacle)
{
    const auto begin = std::chrono::steady_clock::now();
    VoxelGrid grid = options.voxeliser == "gpu" ? voxelise_on_gpu(obstacle, options.voxels)
                                                : voxelise(obstacle, options.voxels);
    const std::chrono::duration<double, std::milli> time = std::chrono::steady_clock::now() - begin;
    std::cout << "voxels: " << grid.resolution << "^3 of " << grid.cell_size << " m in "
              << 4 * grid.words.size() << " bytes, made in " << time.count() << " ms (--voxeliser "
              << options.voxeliser << ")" << std::endl;
    return grid;
}

GlObject upload_terrain(const Terrain& terrain)
{
    GlObject texture = make_texture();
    glBindTexture(GL_TEXTURE_2D, texture);
    glTexImage2D(GL_TEXTURE_2D, 0, GL_R32F, Terrain::squares, Terrain::squares, 0, GL_RED, GL_FLOAT,
                 terrain.heights.data());
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_LINEAR);
    for (const GLenum wrap : {GL_TEXTURE_WRAP_S, GL_TEXTURE_WRAP_T})
        glTexParameteri(GL_TEXTURE_2D, wrap, GL_CLAMP_TO_EDGE);
    return texture;
}

}  // namespace

SolidScene::SolidScene(Window& window)
    : scene(load_scene(window.options().scene, window.options().up, nullptr,
                       window.options().metres)),
      collision(load_collision(window.options(), scene)),
      grid(make_grid(window.options(), obstacle())), voxels(upload_voxels(grid)),
      drawn(with_ground(scene, grid)), mesh(drawn), pictures(drawn)
{
    Terrain ground;  // level
    if (window.options().metres) {
        ground = terrain_of(obstacle());
        window.stand_on(ground);
    }
    terrain = upload_terrain(ground);
    block.update(GRID_BLOCK,
                 {grid.origin, grid.cell_size, grid.resolution, ground.half_size, 0, 0});
}

void SolidScene::bind() const
{
    block.bind(GRID_BLOCK);
    bind_texture(VOXELS_UNIT, GL_TEXTURE_3D, voxels);
    bind_texture(TERRAIN_UNIT, GL_TEXTURE_2D, terrain);
}

void SolidScene::draw(Program& program) const
{
    for (size_t i = 0; i < drawn.submeshes.size(); ++i) {
        pictures.set(program, i);
        mesh.draw(drawn.submeshes[i]);
    }
}
