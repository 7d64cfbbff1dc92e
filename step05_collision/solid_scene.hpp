// The scene, in every form that the steps need: read once, however often the snow begins anew.
#pragma once

#include "common/program.hpp"
#include "common/scene/scene.hpp"
#include "step05_collision/scene_mesh.hpp"
#include "step05_collision/scene_pictures.hpp"
#include "step05_collision/voxel_grid.hpp"

class Window;

struct SolidScene {
    explicit SolidScene(const Window& window);  // from the file and with the voxels of its options

    Scene scene;
    VoxelGrid grid;   // to be landed on
    GlObject voxels;  // the grid, on the GPU
    Scene drawn;      // the scene and the ground beside it
    SceneMesh mesh;
    ScenePictures pictures;
};

// Gives the program in use the grid's place in the world (grid.glsl), and with it its voxels
// (voxels.glsl).
void set_grid(Program& program, const VoxelGrid& grid);
void set_voxels(Program& program, const SolidScene& solid);

// Draws the scene, material by material, with the program in use (picture.glsl).
void draw_scene(Program& program, const SolidScene& solid);
