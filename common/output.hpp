// The files a run leaves: a picture of its last frame and a list of its flakes.
#pragma once

#include <filesystem>
#include <glm/glm.hpp>
#include <span>

#include "common/snow.hpp"

// Writes what is in the back buffer, `size` pixels, as a PNG. Throws std::runtime_error.
void save_screenshot(const std::filesystem::path& path, glm::ivec2 size);

// Writes one line a flake, `index,x,y,z,age,vx,vy,vz,rest`, with the nine significant digits that
// tell any two floats apart. Does nothing if `path` is empty. Throws std::runtime_error.
void dump_flakes(const std::filesystem::path& path, std::span<const snow::Particle> flakes);
