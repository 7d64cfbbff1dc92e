// The snow that lies, on the GPU: a shader storage buffer with the mass of snow in every voxel.
#pragma once

#include <GL/glew.h>

#include <filesystem>
#include <optional>
#include <vector>

#include "common/gl_object.hpp"
#include "common/snow.hpp"
#include "step05_collision/voxel_grid.hpp"

class SnowCover {
public:
    // For a grid with that many voxels along x and z, and so many layers of them. Throws
    // std::runtime_error if the card has no buffer that large.
    SnowCover(int resolution, int layers);

    GLuint buffer() const { return mass_; }

    // Lets the shaders of snow_cover.glsl add to it and take from it.
    void bind() const;

    // The mass of a flake as wide as 1 m, in units of which 65536 fill a cell; it grows with the
    // cube of the diameter. It takes so much for the flakes that fall on a square metre in a minute
    // to fill it as deep as the weather says, however many flakes there are and however fast.
    float flake_mass(const snow::Weather& weather, const VoxelGrid& grid);

    // The mass in every cell, x fastest, then y. For the end, never in a frame.
    std::vector<GLuint> read() const;

    // After the last frame: prints the line in which the mass that lies and the mass that has
    // melted make up what the flakes have deposited. And writes one line for every cell that holds
    // snow, `i,j,k,mass`, to `path`, unless that is empty, after one that says where cell (0, 0, 0)
    // begins and how large cells are, m. Throws std::runtime_error.
    void report(const VoxelGrid& grid, const std::filesystem::path& path) const;

private:
    size_t resolution_, layers_;
    GlObject mass_, sums_;
    std::optional<snow::Weather> weather_;  // for which flake_mass_ was computed
    float flake_mass_ = 0;
};
