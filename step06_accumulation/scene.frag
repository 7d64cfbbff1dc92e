#version 430 core
// The scene under snow that lies in cells.

#include "step06_accumulation/cover/snow_depth.glsl"
#include "step06_accumulation/whitened.glsl"
