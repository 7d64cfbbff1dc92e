// The light of a winter's day, and what it makes of surfaces and flakes. `struct Light` is GLSL and C++, like
// CameraView. All colours are linear. Light is measured by what it makes of a white surface that faces it: 1 is
// white paper in a bright room, snow in the sun is brighter. SHADOW, OCCLUSION and LAMP are defined if there is
// such a thing: see Daylight::parts.

struct Light {
    mat4 to_shadow_map;     // world space to the clip space in which the shadow map was drawn
    vec3 to_sun;            // where the sun stands, or the moon by night: length 1, world space
    float has_shadow;       // 1: there is a shadow map
    vec3 sun;               // light of the sun, or the moon
    float has_occlusion;    // 1: the scene hides a part of the sky
    vec3 zenith;            // colour of the sky overhead
    float stars;            // 0 to 1
    vec3 horizon;           // and where it meets the ground: the colour of the air, too
    float extinction;       // part of the light that a metre of air takes away, 1/m
    vec3 twilight;          // what is added to that where the sun sets
    float unused;           // fills the row of four
    vec3 sky;               // light of the whole sky on a surface that faces up
    float lamp_is_on;       // 0 to 1
    vec3 ground;            // light from below on a surface that faces down
    float lamp_radius;      // m
    vec3 lamp;              // light of the lamp at a distance of 1 m
    float grid_size;        // m, edge of the cube in which the scene stands
    vec3 lamp_position;     // m
    float unused_too;
    vec3 grid_corner;       // m, the cube's corner of least x, y and z
    float unused_as_well;
};

#ifndef __cplusplus
#include "step06_accumulation/winter/camera/camera.glsl"

layout(std140, binding = LIGHT_BLOCK) uniform LightBlock
{
    Light light;
};
uniform sampler2DShadow shadow_map;
uniform sampler3D sky_seen;  // see ambient_occlusion.cpp

// A point, and where it is found in what light is looked up in. All change evenly along a line, so vertices
// compute them.
struct Place {
    vec3 world;          // m
    vec3 in_grid;        // see across_grid
    vec3 in_shadow_map;  // 0 to 1
};

// 0 to 1 across the cube in which the scene stands.
vec3 across_grid(vec3 position)
{
    return (position - light.grid_corner) / light.grid_size;
}

// Of a point on a surface. normal: length 1, on either side.
Place place_of(vec3 position, vec3 normal)
{
    // Beside it, on the side of the sun: out of its own shadow.
    vec3 beside = position + 0.03 * (dot(normal, light.to_sun) < 0.0 ? -normal : normal);
    vec3 as_drawn = (light.to_shadow_map * vec4(beside, 1.0)).xyz;
    return Place(position, across_grid(position), 0.5 + 0.5 * as_drawn);
}

// How much of the sun reaches this point: 0 in shadow, 1 in the sun. The lookup compares with texels around and
// blends the results (percentage closer filtering: Reeves, Salesin and Cook, "Rendering antialiased shadows
// with depth maps", 1987).
float sunlight_at(Place place)
{
#ifdef SHADOW
    return texture(shadow_map, place.in_shadow_map);
#else
    return 1.0;
#endif
}

// How much of the sky is seen from a surface with this normal: on it falls w + dot(xyz, normal) of the light
// that the whole sky sends to one that faces up.
vec4 sky_seen_from(Place place, vec3 normal)
{
#ifdef OCCLUSION
    vec3 beside = normal / float(textureSize(sky_seen, 0).x);  // the cell that holds the surface
    vec4 texel = texture(sky_seen, place.in_grid + beside);
    return vec4(texel.rgb - 0.5, 0.5 * texel.a);
#else
    return vec4(0.0, 0.5, 0.0, 0.5);
#endif
}

// Light from everywhere but the sun and the lamp. What is not sky is ground, or walls, which are lit as well
// as the sky is seen from here.
vec3 ambient_light(vec3 normal, Place place)
{
    vec4 seen = sky_seen_from(place, normal);
    float part = clamp(seen.w + dot(seen.xyz, normal), 0.0, 1.0);
    return mix(min(2.0 * seen.w, 1.0) * light.ground, light.sky, part);
}

// Light of the lamp on a surface. normal: length 1.
vec3 lamp_light(vec3 normal, Place place)
{
#ifdef LAMP
    vec3 to_lamp = light.lamp_position - place.world;
    float nearness = inversesqrt(max(dot(to_lamp, to_lamp), light.lamp_radius * light.lamp_radius));
    return light.lamp * max(dot(normal, to_lamp), 0.0) * nearness * nearness * nearness;
#else
    return vec3(0.0);
#endif
}

// Light of sun and lamp on a surface. sunlight: the part of the sun's light that gets here. around: how far
// light gets within, so that the sun reaches a little beyond where it grazes.
vec3 direct_light(vec3 normal, Place place, float sunlight, float around)
{
    float facing = max((dot(normal, light.to_sun) + around) / (1.0 + around), 0.0);
    return facing * sunlight * light.sun + lamp_light(normal, place);
}

// What is seen of a dull surface of this colour, from any side. normal: length 1.
vec3 lit(vec3 colour, vec3 normal, Place place, float sunlight, float around)
{
    return colour * (ambient_light(normal, place) + direct_light(normal, place, sunlight, around));
}
#endif
