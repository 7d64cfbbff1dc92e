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

uniform vec3 own_light;  // what the surface shines by itself when the lamp is on

// Finds the fraction of the surface that is snow, and the normal, of length 1, towards the viewer.
void look(out float cover, out vec3 facing)
{
    bool is_behind = is_skirt == 0.0 && !gl_FrontFacing;
    vec3 normal = normalize(is_behind ? -base_normal : base_normal);
    vec4 fine = texture(grain, spot.position.xz / grain_size);
    // The first flakes fill the small hollows of the surface.
    const float hollow = 0.012;  // m, deepest
    vec3 lying = snow_of(texture(snow, vec3(spot.in_grid.x, base, spot.in_grid.z)));
    lying = mix(lying, vec3(min(frame.field_depth, deep), 0.0, 0.0), beyond);
    // Steep surfaces hold less.
    float slipping = deep * (1.0 - smoothstep(0.1, 0.4, normal.y));
    cover = is_behind ? 0.0 : smoothstep(0.0, 0.008, lying.x - hollow * fine.b - slipping);
    // What fills hollows is deeper in some of them than in others, and yet level.
    vec3 snow_normal = normal / max(normal.y, 0.2) - (1.0 - evened) * vec3(lying.y, 0.0, lying.z);
    if (is_skirt > 0.0) {
        cover = is_skirt;
        snow_normal = normal + vec3(0.0, 0.5, 0.0);
    }
    const float roughness = 0.5;
    snow_normal.xz += roughness * (fine.rg - 0.5);
    facing = normalize(mix(normal, normalize(snow_normal), cover));
}

// How much of the sun's light crystals mirror into the eye. There is one in each square, as large as some
// pixels and turned at random; few are turned so that they flash.
float glint(vec3 normal)
{
    vec3 to_eye = frame.eye - spot.position;
    float away = max(length(to_eye), 0.001);
    // Squares of 4 mm, or twice, four times ... as wide, so that they stay larger than a pixel.
    float pixel = 2.0 * away / (frame.projection[1][1] * float(frame.window_size.y));  // m
    float square = 0.004 * exp2(max(ceil(log2(1.5 * pixel / 0.004)), 0.0));
    ivec2 here = ivec2(floor(spot.position.xz / square));
    uint bits = hash(uint(here.x) ^ hash(uint(here.y)));
    vec3 turn = vec3(bits & 1023u, bits >> 10u & 1023u, bits >> 20u & 1023u) / 1023.0 - 0.5;
    vec3 crystal = normal + 1.2 * turn, halfway = frame.to_sun + to_eye / away;  // neither may be 0
    float mirrored = dot(crystal, halfway) / max(length(crystal) * length(halfway), 0.001);
    return 4.0 * smoothstep(0.997, 1.0, mirrored) * exp(-0.06 * away);
}

void main()
{
    vec3 surface = with_picture(base_colour), normal;
    float cover;
    look(cover, normal);
    // Snow shines broadly where it mirrors the sun.
    float shine = max(dot(normal, normalize(frame.to_sun + normalize(frame.eye - spot.position))), 0.0);
    shine *= shine, shine *= shine, shine *= shine;  // to the 8th
    float mirrored = 0.1 * cover * shine;
#ifdef SPARKLE
    if (cover > 0.5) mirrored += glint(normal);
#endif
    float sunlight = sunlight_at(spot);
    vec3 below = frame.lamp_is_on * own_light + (1.0 - beyond) * mirrored_sky(normal, spot);
    surface = mix(wet(surface, normal, spot), snow_colour, cover);
    vec3 radiance = lit(surface, normal, spot, sunlight, light_within * cover) +
                    mirrored * sunlight * frame.sun + (1.0 - cover) * below;
    colour = vec4(air.rgb + air.a * radiance, 1.0);
}
