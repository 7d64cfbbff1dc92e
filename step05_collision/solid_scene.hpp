// The scene, in every form that the steps need: read once, however often the snow begins anew.
#pragma once

#include <optional>

#include "common/program.hpp"
#include "common/scene/scene.hpp"
#include "step05_collision/scene_mesh.hpp"
#include "step05_collision/scene_pictures.hpp"
#include "step05_collision/voxel_grid.hpp"

class Window;

struct SolidScene {
    explicit SolidScene(Window& window);  // from the files and with the voxels of its options

    // The triangles that flakes land on.
    const Scene& obstacle() const { return collision ? *collision : scene; }

    Scene scene;
    std::optional<Scene> collision;  // to be landed on instead: --collision
    VoxelGrid grid;                  // of the obstacle
    GlObject voxels;                 // the grid on the GPU
    Scene drawn;                     // the scene, and the ground beside the obstacle
    SceneMesh mesh;                  // the same on the GPU
    ScenePictures pictures;          // on it
    float terrain_half_size;         // m, see terrain.glsl
    GlObject terrain;                // on the GPU
};

// Gives the program in use the grid's place in the world (grid.glsl), and with it its voxels
// (voxels.glsl), or how high the ground stands (terrain.glsl).
void set_grid(Program& program, const VoxelGrid& grid);
void set_voxels(Program& program, const SolidScene& solid);
void set_terrain(Program& program, const SolidScene& solid);

// Draws the scene, material by material, with the program in use (picture.glsl).
void draw_scene(Program& program, const SolidScene& solid);
