#include "step05_collision/solid_scene.hpp"

#include "common/window.hpp"
#include "step05_collision/ground.hpp"

SolidScene::SolidScene(const Window& window)
    : scene(load_scene(window.options().scene, window.options().up)),
      grid(voxelise(scene, window.options().voxels)), voxels(upload_voxels(grid)),
      drawn(with_ground(scene, grid)), mesh(drawn), pictures(drawn)
{}

void set_grid(Program& program, const VoxelGrid& grid)
{
    program.set("grid_origin", grid.origin);
    program.set("cell_size", grid.cell_size);
    program.set("resolution", grid.resolution);
}

void set_voxels(Program& program, const SolidScene& solid)
{
    set_grid(program, solid.grid);
    program.set_texture("voxels", VOXELS_UNIT, GL_TEXTURE_3D, solid.voxels);
}

void draw_scene(Program& program, const SolidScene& solid)
{
    for (size_t i = 0; i < solid.drawn.submeshes.size(); ++i) {
        solid.pictures.set(program, i);
        solid.mesh.draw(solid.drawn.submeshes[i]);
    }
}
