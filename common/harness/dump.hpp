// A list of the flakes as they are after the last frame.
#pragma once

#include <filesystem>
#include <span>

#include "common/snow.hpp"

// Writes one line a flake, `index,x,y,z,age,vx,vy,vz,rest`, with the nine significant digits that
// tell any two floats apart. Does nothing if `path` is empty. Throws std::runtime_error.
void dump_flakes(const std::filesystem::path& path, std::span<const snow::Particle> flakes);
