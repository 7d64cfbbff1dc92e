// The scene, in every form that the steps need: read once, however often the snow begins anew.
#pragma once

#include "common/options.hpp"
#include "common/scene.hpp"
#include "step05_collision/voxel_grid.hpp"

struct SolidScene {
    explicit SolidScene(const Options& options)
        : scene(load_scene(options.scene, options.up)), mesh(scene.vertices),
          grid(voxelise(scene, options.voxels)), voxels(upload_voxels(grid))
    {}

    Scene scene;
    SceneMesh mesh;   // to be drawn
    VoxelGrid grid;   // to be landed on
    GlObject voxels;  // the grid, on the GPU
};
