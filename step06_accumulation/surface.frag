#version 430 core
// A surface of the scene, under as much snow as lies on it.

#include "common/snow.glsl"
#include "step06_accumulation/light.glsl"
#include "step06_accumulation/snow_depth.glsl"

in vec3 base_position;
in vec3 world_position;
in vec3 base_normal;
in vec3 base_colour;
in float is_skirt;

out vec4 colour;

const vec3 snow_colour = vec3(0.90, 0.93, 0.97);

// Uniform in [0, 1), one number for each square of the plane.
float grain(ivec2 square)
{
    return float(hash(uint(square.x) ^ hash(uint(square.y))) >> 8u) * (1.0 / 16777216.0);
}

// How much of the surface is hidden by snow, 0 to 1. The first flakes fill the small hollows of the surface.
float cover_of(float depth, vec3 point)
{
    const float hollow = 0.012;  // m, deepest
    float coarse = grain(ivec2(floor(point.xz / 0.02))), fine = grain(ivec2(floor(point.xz / 0.005)));
    return smoothstep(0.0, 0.008, depth - hollow * mix(coarse, fine, 0.5));
}

void main()
{
    vec3 normal = normalize(base_normal);
    float cover = is_skirt;
    vec3 snow_normal = normalize(normal + vec3(0.0, 0.5, 0.0));
    if (is_skirt == 0.0 && normal.y > 0.1 && gl_FrontFacing) {
        vec3 snow = snow_at(base_position);
        cover = cover_of(snow.x, base_position);
        snow_normal = normalize(normal / max(normal.y, 0.2) - vec3(snow.y, 0.0, snow.z));
    }
    normal = normalize(mix(normal, snow_normal, cover));
    vec3 radiance = lit(mix(base_colour, snow_colour, cover), normal, world_position);
    colour = vec4(tone_mapped(through_air(radiance, world_position)), 1.0);
}
