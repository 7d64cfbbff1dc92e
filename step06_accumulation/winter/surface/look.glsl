// What a surface of the scene looks like, under as much snow as lies on it.

#include "step05_collision/picture.glsl"
#include "step06_accumulation/winter/light/light.glsl"
#include "step06_accumulation/winter/surface/snow_colour.glsl"
#include "step06_accumulation/winter/surface/snow_texture.glsl"

uniform sampler3D snow;      // see smooth.comp
uniform sampler2D grain;     // see grain.hpp
uniform float grain_size;    // m, after which it repeats

in Place place;              // on top of the snow
in float base;               // height of the scene below that, 0 to 1 across the grid
in vec3 base_normal;         // of the scene without snow
in vec3 base_colour;
in float is_skirt;           // 1: the side of the snow, where the surface it lies on ends
in float evened;             // 0 to 1: snow has made even what is uneven below it
in float beyond;             // 0 to 1: outside the grid, where nothing is known
in vec4 air;                 // see air.glsl

struct Look {
    vec3 colour;     // of what is seen, linear
    vec3 normal;     // towards the viewer, length 1
    float cover;     // the part of it that is snow
    float sunlight;  // the part of the sun's light that gets here
};

Look look_at_surface()
{
    Look look;
    vec3 surface = with_picture(base_colour);
    bool is_behind = is_skirt == 0.0 && !gl_FrontFacing;
    vec3 normal = normalize(is_behind ? -base_normal : base_normal);
    vec4 fine = texture(grain, place.world.xz / grain_size);
    // The first flakes fill the small hollows of the surface.
    const float hollow = 0.012;  // m, deepest
    vec3 lying = snow_of(texture(snow, vec3(place.in_grid.x, base, place.in_grid.z)));
    lying = mix(lying, vec3(min(camera.field_depth, deep), 0.0, 0.0), beyond);
    // What is steep holds less.
    float slipping = deep * (1.0 - smoothstep(0.1, 0.4, normal.y));
    float cover = is_behind ? 0.0 : smoothstep(0.0, 0.008, lying.x - hollow * fine.b - slipping);
    // What fills hollows is deeper in some places than in others, and yet level.
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
    look.sunlight = sunlight_at(place);
    return look;
}

// The light that it sends to the eye. Snow shines broadly where it mirrors the sun.
vec3 light_from(Look look)
{
    vec3 halfway = normalize(light.to_sun + normalize(camera.eye - place.world));
    float shine = max(dot(look.normal, halfway), 0.0);
    shine *= shine, shine *= shine, shine *= shine;  // to the 8th
    return lit(look.colour, look.normal, place, look.sunlight, light_within * look.cover) +
           0.1 * look.cover * shine * look.sunlight * light.sun;
}
