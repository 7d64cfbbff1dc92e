#version 430 core
// The scene as the sun sees it; only its depth is kept.

#include "step06_accumulation/winter/light/light.glsl"

layout(location = 0) in vec3 position;
layout(location = 3) in vec2 uv;

out vec2 picture_uv;

void main()
{
    picture_uv = uv;
    gl_Position = frame.to_shadow_map * vec4(position, 1.0);
}
