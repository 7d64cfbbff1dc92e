#version 330 core
#extension GL_ARB_shader_atomic_counters : require
#extension GL_ARB_shading_language_420pack : require  // layout(binding = ...)
// The variant "voxels".

#include "step05_collision/collide_voxels.glsl"
#include "step05_collision/update.glsl"
