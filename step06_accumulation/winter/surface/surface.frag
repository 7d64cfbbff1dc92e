#version 430 core
// A surface of the scene, under as much snow as lies on it. Crystals on that flash in the sun (SPARKLE).

#include "common/snow.glsl"
#include "step05_collision/picture.glsl"
#include "step06_accumulation/winter/light/light.glsl"
#include "step06_accumulation/winter/surface/snow_colour.glsl"
#include "step06_accumulation/winter/surface/snow_texture.glsl"

layout(binding = SNOW_UNIT) uniform sampler3D snow;    // see smooth.comp
layout(binding = GRAIN_UNIT) uniform sampler2D grain;  // see grain.hpp

in Spot spot;                // on top of the snow
in float base;               // height of the scene below that, 0 to 1 across the grid
in vec3 base_normal;         // of the scene without snow
in vec3 base_colour;
in float is_skirt;           // 1: the side of the snow, where the surface it lies on ends
in float evened;             // 0 to 1: snow has made even what is uneven below it
in float beyond;             // 0 to 1: outside the grid, where nothing is known
in vec4 air;                 // see air.glsl

out vec4 colour;

#ifdef LAMP
uniform vec3 own_light;  // what the surface shines by itself
#else
const vec3 own_light = vec3(0.0);
#endif

struct Look {
    vec3 colour;     // of what is seen, linear
    vec3 normal;     // towards the viewer, length 1
    float cover;     // the fraction of it that is snow
    float sunlight;  // the fraction of the sun's light that gets here
};

Look look_at_surface()
{
    Look look;
    vec3 surface = with_picture(base_colour);
    bool is_behind = is_skirt == 0.0 && !gl_FrontFacing;
    vec3 normal = normalize(is_behind ? -base_normal : base_normal);
    vec4 fine = texture(grain, spot.position.xz / grain_size);
    // The first flakes fill the small hollows of the surface.
    const float hollow = 0.012;  // m, deepest
    vec3 lying = snow_of(texture(snow, vec3(spot.in_grid.x, base, spot.in_grid.z)));
    lying = mix(lying, vec3(min(frame.field_depth, deep), 0.0, 0.0), beyond);
    // Steep surfaces hold less.
    float slipping = deep * (1.0 - smoothstep(0.1, 0.4, normal.y));
    float cover = is_behind ? 0.0 : smoothstep(0.0, 0.008, lying.x - hollow * fine.b - slipping);
    // What fills hollows is deeper in some of them than in others, and yet level.
    vec3 snow_normal = normal / max(normal.y, 0.2) - (1.0 - evened) * vec3(lying.y, 0.0, lying.z);
    if (is_skirt > 0.0) {
        cover = is_skirt;
        snow_normal = normal + vec3(0.0, 0.5, 0.0);
    }
    const float roughness = 0.5;
    snow_normal.xz += roughness * (fine.rg - 0.5);
    look.cover = cover;
    look.normal = normalize(mix(normal, normalize(snow_normal), cover));
    look.colour = mix(surface, snow_colour, cover);
    look.sunlight = sunlight_at(spot);
    return look;
}

// The light that it sends to the eye. Snow shines broadly where it mirrors the sun.
vec3 light_from(Look look)
{
    vec3 halfway = normalize(frame.to_sun + normalize(frame.eye - spot.position));
    float shine = max(dot(look.normal, halfway), 0.0);
    shine *= shine, shine *= shine, shine *= shine;  // to the 8th
    return lit(look.colour, look.normal, spot, look.sunlight, light_within * look.cover) +
           0.1 * look.cover * shine * look.sunlight * frame.sun;
}

#ifdef SPARKLE
// Uniform in [0, 1), one number for each square of the plane.
float random_of(ivec2 square)
{
    return float(hash(uint(square.x) ^ hash(uint(square.y))) >> 8u) * (1.0 / 16777216.0);
}

// Light that crystals mirror into the eye. There is one in each square, as large as some pixels and turned at
// random; few are turned so that they flash.
vec3 glint(Look look)
{
    vec3 to_eye = frame.eye - spot.position;
    float away = max(length(to_eye), 0.001);
    // Squares of 4 mm, or twice, four times ... as wide, so that they stay larger than a pixel.
    float pixel = 2.0 * away / (frame.projection[1][1] * float(frame.window_size.y));  // m
    float square = 0.004 * exp2(max(ceil(log2(1.5 * pixel / 0.004)), 0.0));
    ivec2 here = ivec2(floor(spot.position.xz / square));
    vec3 turn = vec3(random_of(here), random_of(here + 7919), random_of(here - 7919)) - 0.5;
    vec3 crystal = look.normal + 1.2 * turn, halfway = frame.to_sun + to_eye / away;  // neither may be 0
    float mirrored = dot(crystal, halfway) / max(length(crystal) * length(halfway), 0.001);
    return 4.0 * smoothstep(0.997, 1.0, mirrored) * exp(-0.06 * away) * look.sunlight * frame.sun;
}
#endif

void main()
{
    Look look = look_at_surface();
    vec3 radiance = light_from(look) + (1.0 - look.cover) * own_light;
#ifdef SPARKLE
    if (look.cover > 0.5) radiance += glint(look);
#endif
    colour = vec4(air.rgb + air.a * radiance, 1.0);
}
