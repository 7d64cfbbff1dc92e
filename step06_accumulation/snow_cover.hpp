// The snow that lies, on the GPU: a shader storage buffer with the mass of snow in every voxel.
#pragma once

#include <GL/glew.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <filesystem>
#include <iostream>
#include <sstream>
#include <stdexcept>
#include <string>
#include <vector>

#include "common/files.hpp"
#include "common/gl_object.hpp"
#include "common/snow.hpp"
#include "step05_collision/voxel_grid.hpp"

class SnowCover {
public:
    explicit SnowCover(const VoxelGrid& grid)
        : cells_(size_t(grid.resolution) * size_t(grid.resolution) * size_t(grid.resolution)),
          cell_size_(grid.cell_size), buffer_(make_buffer())
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

    // The mass of one flake, in units of which 65536 fill a cell: as much as it takes for the
    // flakes that fall on a square metre in a minute to fill it as deep as the weather says,
    // however many flakes there are.
    GLuint flake_mass(const snow::Weather& weather)
    {
        const snow::Emitter& cloud = weather.emitters[0];
        const double area = 4.0 * cloud.half_size.x * cloud.half_size.z;                 // m2
        const double cycle = cloud.centre.y / cloud.terminal_speed + weather.melt_time;  // s
        const double volume =
            weather.snowfall / 60.0 * area * cycle / std::max(1u, weather.particles);  // m3
        const double mass = 65536 * volume / std::pow(cell_size_, 3);
        const GLuint now = GLuint(std::min(mass + 0.5, 1e9));
        same_mass_ = same_mass_ && (flake_mass_ == 0 || now == flake_mass_);
        return flake_mass_ = now;
    }

    // The mass in every cell, x fastest, then y. For the end, never in a frame.
    std::vector<GLuint> read() const
    {
        std::vector<GLuint> mass(cells_);
        glMemoryBarrier(GL_BUFFER_UPDATE_BARRIER_BIT);
        glBindBuffer(GL_SHADER_STORAGE_BUFFER, buffer_);
        glGetBufferSubData(GL_SHADER_STORAGE_BUFFER, 0, GLsizeiptr(bytes()), mass.data());
        return mass;
    }

    // Prints the line in which the mass that lies and the mass that has melted make up what the
    // flakes have deposited.
    void print(const std::vector<GLuint>& mass, GLuint64 melted, GLuint deposited) const
    {
        uint64_t sum = 0;
        for (const GLuint cell : mass) sum += cell;
        std::cout << "cover: lying " << sum << " + melted " << melted
                  << (same_mass_ ? " = deposited " : ", deposited ") << deposited
                  << (same_mass_ ? " x " + std::to_string(flake_mass_) : " flakes of changing mass")
                  << std::endl;
    }

private:
    size_t bytes() const { return cells_ * sizeof(GLuint); }

    size_t cells_;
    float cell_size_;
    GLuint flake_mass_ = 0;
    bool same_mass_ = true;  // all through the run, so that the sum can be checked
    GlObject buffer_;
};

// Writes one line for every cell that holds snow, `i,j,k,mass`, after one that says where cell (0,
// 0, 0) begins and how large cells are, m. Does nothing if `path` is empty. Throws
// std::runtime_error.
inline void dump_cover(const std::filesystem::path& path, const VoxelGrid& grid,
                       const std::vector<GLuint>& mass)
{
    if (path.empty()) return;
    std::ostringstream csv;
    csv << "# origin " << grid.origin.x << " " << grid.origin.y << " " << grid.origin.z << " cell "
        << grid.cell_size << " full 65536\ni,j,k,mass\n";
    const size_t n = size_t(grid.resolution);
    for (size_t cell = 0; cell < mass.size(); ++cell) {
        if (mass[cell] == 0) continue;
        csv << cell % n << "," << cell / n % n << "," << cell / (n * n) << "," << mass[cell]
            << "\n";
    }
    write_file(path, csv.str());
}
