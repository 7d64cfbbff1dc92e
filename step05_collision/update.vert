#version 330 core
#extension GL_ARB_shader_atomic_counters : require
// The variant "voxels".

#include "step05_collision/collide_voxels.glsl"
#include "step05_collision/update.glsl"
