// What a run leaves behind: files, pictures of its frames, and a list of its flakes.
#pragma once

#include <filesystem>
#include <glm/glm.hpp>
#include <span>
#include <string>
#include <string_view>

#include "common/snow.hpp"

// Throws std::runtime_error unless `path` can be written: asked at the start, not after the last
// frame.
void check_writable(const std::filesystem::path& path);

// Writes a file whole or not at all: beside it first, then renamed. A device, a pipe and what a
// link points to are written as they are. Throws std::runtime_error.
void write_file(const std::filesystem::path& path, std::string_view bytes);

// The back buffer, `size` pixels of it, as the bytes of a PNG file. Throws std::runtime_error.
std::string png_of_back_buffer(glm::ivec2 size);

// Writes one line a flake, `index,x,y,z,age,vx,vy,vz,rest`, with the nine significant digits that
// tell any two floats apart. Throws std::runtime_error.
void write_dump(const std::filesystem::path& path, std::span<const snow::Particle> flakes);
