// What the light of a winter's day makes of surfaces and flakes. SHADOW, OCCLUSION and LAMP are defined if
// there is such a thing: see permutations.hpp.

#include "step05_collision/grid.glsl"
#include "step06_accumulation/winter/frame.glsl"

layout(binding = SHADOW_UNIT) uniform sampler2DShadow shadow_map;
layout(binding = SKY_VISIBILITY_UNIT) uniform sampler3D sky_visibility;  // see sky_visibility.cpp

// A point, and where it is found in the textures of light. All change evenly along a line, so vertices compute
// them.
struct Spot {
    vec3 position;       // m
    vec3 in_grid;        // see across_grid
    vec3 in_shadow_map;  // 0 to 1
};

// 0 to 1 across the cube in which the scene stands.
vec3 across_grid(vec3 position)
{
    return (position - grid.origin) / (grid.cell_size * float(grid.resolution));
}

// A point on a surface. normal: length 1, on either side.
Spot spot_at(vec3 position, vec3 normal)
{
    // Beside it, on the side of the sun: out of its own shadow.
    vec3 beside = position + 0.03 * (dot(normal, frame.to_sun) < 0.0 ? -normal : normal);
    vec3 as_drawn = (frame.to_shadow_map * vec4(beside, 1.0)).xyz;
    return Spot(position, across_grid(position), 0.5 + 0.5 * as_drawn);
}

// How much of the sun reaches this point: 0 in shadow, 1 in the sun. The lookup compares with texels around and
// blends the results (percentage closer filtering: Reeves, Salesin and Cook, "Rendering antialiased shadows
// with depth maps", 1987).
float sunlight_at(Spot spot)
{
#ifdef SHADOW
    return texture(shadow_map, spot.in_shadow_map);
#else
    return 1.0;
#endif
}

// How much of the sky is seen from a surface with this normal: on it falls w + dot(xyz, normal) of the light
// that the whole sky sends to one that faces up.
vec4 sky_seen_from(Spot spot, vec3 normal)
{
#ifdef OCCLUSION
    vec3 beside = normal / float(textureSize(sky_visibility, 0).x);  // the cell that holds the surface
    vec4 texel = texture(sky_visibility, spot.in_grid + beside);
    return vec4(texel.rgb - 0.5, 0.5 * texel.a);
#else
    return vec4(0.0, 0.5, 0.0, 0.5);
#endif
}

// Light from everywhere but the sun and the lamp. Where there is no sky there is ground, or walls, which are
// lit as well as the sky is seen from here.
vec3 ambient_light(vec3 normal, Spot spot)
{
    vec4 seen = sky_seen_from(spot, normal);
    float sky = clamp(seen.w + dot(seen.xyz, normal), 0.0, 1.0);
    return mix(min(2.0 * seen.w, 1.0) * frame.ground, frame.sky, sky);
}

// How wet rain makes a surface, 0 to 1: it is dry where little of the sky is seen.
float wetness_at(vec3 normal, Spot spot)
{
#ifdef WET
    return frame.wetness * smoothstep(0.1, 0.3, sky_seen_from(spot, normal).w);
#else
    return 0.0;
#endif
}

// A dull colour when it is wet: darker, as some of the light that enters water does not get out again (Lekner
// and Dorf, "Why some things are darker when wet", 1988).
vec3 wet(vec3 colour, vec3 normal, Spot spot)
{
    return colour * mix(1.0, 0.55, wetness_at(normal, spot));
}

// The sky that a wet surface mirrors, more of it the flatter one looks (Schlick 1994; water's index is 1.33).
vec3 mirrored_sky(vec3 normal, Spot spot)
{
    float facing = max(dot(normal, normalize(frame.eye - spot.position)), 0.0);
    float mirrored = wetness_at(normal, spot) * max(normal.y, 0.0) * (0.02 + 0.98 * pow(1.0 - facing, 5.0));
    return mirrored * mix(frame.horizon, frame.zenith, facing);
}

// Light of sun and lamp on a surface. sunlight: the fraction of the sun's light that gets here. around: how far
// light gets within, so that the sun reaches a little beyond where it grazes.
vec3 direct_light(vec3 normal, Spot spot, float sunlight, float around)
{
    float facing = max((dot(normal, frame.to_sun) + around) / (1.0 + around), 0.0);
    vec3 light = facing * sunlight * frame.sun;
#ifdef LAMP
    vec3 to_lamp = frame.lamp_position - spot.position;
    float nearness = inversesqrt(max(dot(to_lamp, to_lamp), frame.lamp_radius * frame.lamp_radius));
    light += frame.lamp * max(dot(normal, to_lamp), 0.0) * nearness * nearness * nearness;
#endif
    return light;
}

// The light that a dull surface of this colour sends to any side. normal: length 1.
vec3 lit(vec3 colour, vec3 normal, Spot spot, float sunlight, float around)
{
    return colour * (ambient_light(normal, spot) + direct_light(normal, spot, sunlight, around));
}
