// The snow that lies, on the GPU: a shader storage buffer with the mass of snow in every voxel.
#pragma once

#include <GL/glew.h>

#include <cstdint>
#include <iostream>
#include <stdexcept>
#include <string>
#include <vector>

#include "common/gl_object.hpp"
#include "common/snow.hpp"
#include "step05_collision/voxel_grid.hpp"

class SnowCover {
public:
    SnowCover(const VoxelGrid& grid, const snow::Weather& weather)
        : cells_(size_t(grid.resolution) * size_t(grid.resolution) * size_t(grid.resolution)),
          flake_mass_(mass_of_a_flake(grid, weather)), buffer_(make_buffer())
    {
        GLint64 largest = 0;
        glGetInteger64v(GL_MAX_SHADER_STORAGE_BLOCK_SIZE, &largest);
        if (GLint64(bytes()) > largest) {
            throw std::runtime_error("--voxels " + std::to_string(grid.resolution) +
                                     ": the snow cover needs " + std::to_string(bytes()) +
                                     " bytes, this card's buffers end at " +
                                     std::to_string(largest));
        }
        glBindBuffer(GL_SHADER_STORAGE_BUFFER, buffer_);
        glBufferData(GL_SHADER_STORAGE_BUFFER, GLsizeiptr(bytes()), nullptr, GL_DYNAMIC_COPY);
        glClearBufferData(GL_SHADER_STORAGE_BUFFER, GL_R32UI, GL_RED_INTEGER, GL_UNSIGNED_INT,
                          nullptr);
        glBindBufferBase(GL_SHADER_STORAGE_BUFFER, 1, buffer_);
    }

    GLuint flake_mass() const { return flake_mass_; }  // units, full_cell of which fill a cell

    // Reads the grid back and prints whether it holds what was deposited. For the end, never in a
    // frame.
    void print(GLuint deposited) const
    {
        std::vector<GLuint> mass(cells_);
        glMemoryBarrier(GL_BUFFER_UPDATE_BARRIER_BIT);
        glBindBuffer(GL_SHADER_STORAGE_BUFFER, buffer_);
        glGetBufferSubData(GL_SHADER_STORAGE_BUFFER, 0, GLsizeiptr(bytes()), mass.data());
        uint64_t sum = 0;
        for (const GLuint cell : mass) sum += cell;
        std::cout << "cover: mass " << sum << " = deposited " << deposited << " x " << flake_mass_
                  << std::endl;
    }

private:
    static constexpr double full_cell = 65536;  // as in snow_cover.glsl

    // As much as it takes for the flakes that fall on one square metre in a minute to fill it as
    // deep as the weather says, however many flakes there are.
    static GLuint mass_of_a_flake(const VoxelGrid& grid, const snow::Weather& weather)
    {
        const snow::Emitter& cloud = weather.emitters[0];
        const double area = 4.0 * cloud.half_size.x * cloud.half_size.z;                 // m2
        const double cycle = cloud.centre.y / cloud.terminal_speed + weather.melt_time;  // s
        const double volume =
            weather.snowfall / 60.0 * area * cycle / std::max(1u, weather.particles);  // m3
        const double mass = full_cell * volume / std::pow(grid.cell_size, 3);
        return GLuint(std::min(mass + 0.5, 1e9));
    }

    size_t bytes() const { return cells_ * sizeof(GLuint); }

    size_t cells_;
    GLuint flake_mass_;
    GlObject buffer_;
};
