// The snow that lies, on the GPU: a shader storage buffer with the mass of snow in every voxel.
#pragma once

#include <GL/glew.h>

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
          cell_size_(grid.cell_size), buffer_(make_buffer()), sums_(make_buffer())
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

        const Sums zero{};
        glBindBuffer(GL_SHADER_STORAGE_BUFFER, sums_);
        glBufferData(GL_SHADER_STORAGE_BUFFER, sizeof zero, &zero, GL_DYNAMIC_COPY);
        glBindBufferBase(GL_SHADER_STORAGE_BUFFER, 2, sums_);
    }

    // The mass of a flake as wide as 1 m, in units of which 65536 fill a cell; it grows with the
    // cube of the diameter. It takes so much for the flakes that fall on a square metre in a minute
    // to fill it as deep as the weather says, however many flakes there are and however fast.
    float flake_mass(const snow::Weather& weather) const
    {
        double volume = 0;  // m3 a second, of the cubes around the flakes that come to lie
        for (const snow::uint emitter : {0u, 1u}) {
            const double d = weather.emitters[emitter].diameter, v = weather.variation;
            const double mean = d * d * d * (1 + v * v);  // of the cubes of d (1 - v) to d (1 + v)
            volume += 0.5 * weather.particles * mean / cycle(weather, emitter);
        }
        const snow::Emitter& cloud = weather.emitters[0];
        const double area = 4.0 * cloud.half_size.x * cloud.half_size.z;  // m2
        const double snow = weather.snowfall / 60.0 * area;               // m3 a second
        const double cell = double(cell_size_) * cell_size_ * cell_size_;
        return volume > 0 ? float(65536 * snow / cell / volume) : 0.0f;
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
    void print(const std::vector<GLuint>& mass) const
    {
        uint64_t lying = 0;
        for (const GLuint cell : mass) lying += cell;
        Sums sums{};
        glBindBuffer(GL_SHADER_STORAGE_BUFFER, sums_);
        glGetBufferSubData(GL_SHADER_STORAGE_BUFFER, 0, sizeof sums, &sums);
        std::cout << "cover: lying " << lying << " + melted " << sums.melted << " = deposited "
                  << sums.deposited << std::endl;
    }

private:
    struct Sums {  // as snow_cover.glsl has them: little-endian, the low word first
        GLuint64 deposited, melted;
    };

    size_t bytes() const { return cells_ * sizeof(GLuint); }

    // s from a flake's birth until it is part of the cover: it falls, may bounce, and lies. Found
    // by letting one fall, without what makes flakes differ.
    static double cycle(snow::Weather weather, snow::uint emitter)
    {
        weather.particles = 2;
        weather.variation = weather.turbulence = 0;
        snow::Particle flake = snow::born(emitter, 0, weather);
        flake.position.y = weather.emitters[emitter].centre.y;
        snow::uint step = 0;
        for (; flake.rest == 0 && !snow::gone(flake, emitter, weather); ++step) {
            flake = snow::settle(snow::move(flake, weather), weather);
            flake = snow::accelerate(flake, weather.wind, emitter, step, weather);
        }
        return double(step) * weather.time_step + weather.melt_time;
    }

    size_t cells_;
    float cell_size_;
    GlObject buffer_, sums_;
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
