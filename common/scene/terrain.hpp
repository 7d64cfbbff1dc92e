// How high a scene stands, to the harness: it hangs the clouds above it, and flies over it.
#pragma once

#include "common/harness/terrain.hpp"
#include "common/scene/scene.hpp"

Terrain terrain_of(const Scene& scene);
