// What deep snow fills: between the tiles of a roof it lies higher than on them, and is even on
// top.
#pragma once

#include <vector>

#include "step06_accumulation/winter/surface/snow_surface.hpp"

// Finds for every vertex that snow lifts how high above it a surface would lie, and which way it
// would face, that is even for some decimetres around.
void find_hollows(std::vector<SurfaceSubmesh>& submeshes);
