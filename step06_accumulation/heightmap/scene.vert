#version 430 core
// The scene under snow that lies on a height map.

#include "step06_accumulation/heightmap/snow_depth.glsl"
#include "step06_accumulation/lifted.glsl"
