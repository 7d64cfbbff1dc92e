// The scene, in every form that the steps need: read once, however often the snow begins anew.
#pragma once

#include <optional>

#include "common/program.hpp"
#include "common/scene/scene.hpp"
#include "common/uniform_block.hpp"
#include "step05_collision/scene_mesh.hpp"
#include "step05_collision/scene_pictures.hpp"
#include "step05_collision/voxel_grid.hpp"

class Window;

struct SolidScene {
    explicit SolidScene(Window& window);  // from the files and with the voxels of its options

    // The triangles that flakes land on.
    const Scene& obstacle() const { return collision ? *collision : scene; }

    // Hands the shaders the voxels (voxels.glsl) and the height of the ground (terrain.glsl).
    void bind() const;

    // Draws the scene, material by material, with the program in use (picture.glsl).
    void draw(Program& program) const;

    Scene scene;
    std::optional<Scene> collision;  // to be landed on instead: --collision
    VoxelGrid grid;                  // of the obstacle
    GlObject voxels;                 // the grid on the GPU
    GlObject terrain;                // the height of the ground on the GPU
    UniformBlock<snow::Grid> block;  // where both lie in the world
    Scene drawn;                     // the scene, and the ground beside the obstacle
    SceneMesh mesh;                  // the same on the GPU
    ScenePictures pictures;          // on it
};
