// The light of a winter's day, and what the air makes of it. `struct Light` is GLSL and C++, like CameraView.
// All colours are linear. Light is measured by what it makes of a white surface that faces it: 1 is
// white paper in a bright room, snow in the sun is brighter.

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
    float exposure;
    vec3 sky;               // light of the whole sky on a surface that faces up
    float lamp_is_on;       // 0 to 1
    vec3 ground;            // light from below on a surface that faces down
    float lamp_radius;      // m
    vec3 lamp;              // light of the lamp at a distance of 1 m
    float grid_size;        // m, edge of the cube in which the scene stands
    vec3 lamp_position;     // m
    float unused;           // fills the row of four
    vec3 grid_corner;       // m, the cube's corner of least x, y and z
    float unused_too;
};

#ifndef __cplusplus
#include "step06_accumulation/winter/camera/camera.glsl"

layout(std140, binding = LIGHT_BLOCK) uniform LightBlock
{
    Light light;
};
uniform sampler2DShadow shadow_map;
uniform sampler3D sky_seen;  // see ambient_occlusion.cpp

// How much of the sun reaches this point: 0 in shadow, 1 in the sun, between them along the edge.
float sunlight_at(vec3 position)
{
    if (light.has_shadow == 0.0) return 1.0;
    vec3 place = 0.5 + 0.5 * (light.to_shadow_map * vec4(position, 1.0)).xyz;
    // Each of the four lookups compares and blends four texels (percentage closer filtering: Reeves, Salesin
    // and Cook, "Rendering antialiased shadows with depth maps", 1987).
    vec2 texel = 0.75 / vec2(textureSize(shadow_map, 0));
    return 0.25 * (texture(shadow_map, place + vec3(texel.x, texel.y, 0.0)) +
                   texture(shadow_map, place + vec3(-texel.x, texel.y, 0.0)) +
                   texture(shadow_map, place + vec3(texel.x, -texel.y, 0.0)) +
                   texture(shadow_map, place + vec3(-texel.x, -texel.y, 0.0)));
}

// Size of the cells of sky_seen, m.
float cell_of_sky()
{
    return light.grid_size / float(textureSize(sky_seen, 0).x);
}

// How much of the sky is seen from here: on a surface that faces n falls w + dot(xyz, n) of the light that
// the whole sky sends to one that faces up.
vec4 sky_seen_from(vec3 position)
{
    if (light.has_occlusion == 0.0) return vec4(0.0, 0.5, 0.0, 0.5);
    return texture(sky_seen, (position - light.grid_corner) / light.grid_size);
}

// Light from everywhere but the sun and the lamp. What is not sky is ground, or walls, which are lit as well
// as the sky is seen from here.
vec3 ambient_light(vec3 normal, vec3 position)
{
    vec4 seen = sky_seen_from(position + cell_of_sky() * normal);  // beside the cell that holds the surface
    float part = clamp(seen.w + dot(seen.xyz, normal), 0.0, 1.0);
    return mix(min(2.0 * seen.w, 1.0) * light.ground, light.sky, part);
}

// What is seen of a dull surface of this colour, from any side. normal: length 1.
vec3 lit(vec3 colour, vec3 normal, vec3 position)
{
    vec3 result = ambient_light(normal, position);
    float facing = dot(normal, light.to_sun);
    // A step along the normal, so that no surface lies in its own shadow.
    if (facing > 0.0) result += light.sun * facing * sunlight_at(position + 0.03 * normal);
    vec3 to_lamp = light.lamp_position - position;
    float distance_to_lamp = max(length(to_lamp), light.lamp_radius);
    result += light.lamp * max(dot(normal, to_lamp), 0.0) / pow(distance_to_lamp, 3.0);
    return colour * result;
}

// How the sun makes snow in the air shine that is seen in this direction (length 1): it scatters most light
// forwards, so it glows around the sun (phase function, times pi: Henyey and Greenstein, "Diffuse radiation
// in the Galaxy", 1941).
float glow(vec3 direction)
{
    const float forwards = 0.7;  // mean cosine of the angle of scattering
    float squared = 1.0 + forwards * forwards - 2.0 * forwards * dot(direction, light.to_sun);
    return (1.0 - forwards * forwards) / (4.0 * squared * sqrt(squared));
}

// What is seen of a white flake, which has no side: light from everywhere. It may lie on a surface.
vec3 light_on_flake(vec3 position)
{
    const vec3 up = vec3(0.0, 1.0, 0.0);
    vec3 result = sky_seen_from(position + cell_of_sky() * up).w * (light.sky + light.ground);
    vec3 way = position - camera.eye;
    float part = 0.5 + glow(way / max(length(way), 0.001));
    result += part * sunlight_at(position + 0.03 * up) * light.sun;
    vec3 to_lamp = light.lamp_position - position;
    return result + 0.5 * light.lamp / max(dot(to_lamp, to_lamp), light.lamp_radius * light.lamp_radius);
}

// Colour of so much air that nothing shines through it, seen in this direction (length 1).
vec3 air_light(vec3 direction)
{
    const float sunlit = 0.25;  // part of the air that the sun reaches
    float sunset = max(dot(direction.xz, normalize(light.to_sun.xz)), 0.0);
    return light.horizon + sunset * sunset * light.twilight + sunlit * glow(direction) * light.sun;
}

// Light that the air between the eye and this point sends here from the lamp. Every metre scatters
// extinction / 4 pi of what reaches it to any side; the sum over 1 / distance^2 to the lamp along a line is
// the angle under which the lamp sees that line over its distance from the line.
vec3 lamp_halo(vec3 position)
{
    vec3 from = camera.eye - light.lamp_position, to = position - light.lamp_position;
    float lengths = max(length(from) * length(to), 1e-6);  // the eye, or the point, may be in the lamp
    float angle = acos(clamp(dot(from, to) / lengths, -1.0, 1.0));
    float closest = max(length(cross(from, to)) / distance(camera.eye, position), light.lamp_radius);
    float left = exp(-light.extinction * length(from));  // and on its way here it loses some
    return 0.25 * light.extinction * left * angle / closest * light.lamp;
}

// What arrives at the eye of the radiance that leaves this point: the air takes some of it and adds its own.
vec3 through_air(vec3 radiance, vec3 position)
{
    vec3 way = position - camera.eye;
    float away = length(way);
    if (light.extinction == 0.0 || away < 0.001) return radiance;  // no way has no direction, either
    vec3 air = air_light(way / away);
    vec3 result = mix(air, radiance, exp(-light.extinction * away));
    if (light.lamp_is_on > 0.0) result += lamp_halo(position);
    return result;
}

// As the screen wants it, 0 to 1: it never gets there, so however bright, snow keeps its shades. The curve is
// that by which an eye answers to light (Naka and Rushton 1966; for pictures: Reinhard and Devlin, "Dynamic
// range reduction inspired by photoreceptor physiology", 2005), then that of sRGB (IEC 61966-2-1).
vec3 tone_mapped(vec3 radiance)
{
    const float half_way = 0.65;  // radiance of what is to be half as bright as the screen can be
    const float contrast = 1.2;
    vec3 answer = pow(light.exposure / half_way * radiance, vec3(contrast));
    vec3 linear = answer / (1.0 + answer);
    bvec3 dark = lessThan(linear, vec3(0.0031308));
    return mix(1.055 * pow(linear, vec3(1.0 / 2.4)) - 0.055, 12.92 * linear, dark);
}
#endif
