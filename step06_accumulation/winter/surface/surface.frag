#version 430 core
// A surface of the scene, under as much snow as lies on it.

#include "common/snow.glsl"
#include "step05_collision/picture.glsl"
#include "step06_accumulation/winter/light/light.glsl"
#include "step06_accumulation/winter/surface/smooth_depth.glsl"

uniform bool sparkle;

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

// Light that crystals at the surface of the snow mirror into the eye. There is one in each square, as large
// as some pixels and turned at random; few are turned so that they flash.
vec3 glint(vec3 normal, vec3 point)
{
    vec3 to_eye = camera.eye - point;
    float away = max(length(to_eye), 0.001);
    // Squares of 4 mm, or twice, four times ... as wide, so that they stay larger than a pixel.
    float pixel = 2.0 * away / (camera.projection[1][1] * float(camera.window_size.y));  // m
    float square = 0.004 * exp2(max(ceil(log2(1.5 * pixel / 0.004)), 0.0));
    ivec2 place = ivec2(floor(point.xz / square));
    vec3 turn = vec3(grain(place), grain(place + 7919), grain(place - 7919)) - 0.5;
    vec3 crystal = normal + 1.2 * turn, halfway = light.to_sun + to_eye / away;  // neither may be 0
    float mirrored = dot(crystal, halfway) / max(length(crystal) * length(halfway), 0.001);
    float flash = smoothstep(0.997, 1.0, mirrored) * exp(-0.06 * away);
    return flash > 0.0 ? 4.0 * flash * light.sun * sunlight_at(point + 0.03 * normal) : vec3(0.0);
}

void main()
{
    vec3 surface = with_picture(base_colour);
    bool is_behind = is_skirt == 0.0 && !gl_FrontFacing;
    vec3 normal = normalize(is_behind ? -base_normal : base_normal);  // towards the viewer
    float cover = is_skirt;
    vec3 snow_normal = normalize(normal + vec3(0.0, 0.5, 0.0));
    if (is_skirt == 0.0 && normal.y > 0.1) {
        vec3 snow = snow_at(base_position);
        cover = cover_of(snow.x, base_position);
        snow_normal = normalize(normal / max(normal.y, 0.2) - vec3(snow.y, 0.0, snow.z));
    }
    normal = normalize(mix(normal, snow_normal, cover));
    vec3 radiance = lit(mix(surface, snow_colour, cover), normal, world_position);
    if (sparkle && cover > 0.5) radiance += glint(normal, world_position);
    colour = vec4(tone_mapped(through_air(radiance, world_position)), 1.0);
}
