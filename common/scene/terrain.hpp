// How high a scene stands: clouds hang above it, and the tour flies over it.
#pragma once

#include "common/harness/terrain.hpp"
#include "common/scene/scene.hpp"

Terrain terrain_of(const Scene& scene);
