#version 430 core
// What lies behind the scene: the sky, and the field around the courtyard, which whitens as it
// snows.

#include "common/snow.glsl"
#include "step06_accumulation/winter/light/light.glsl"

out vec4 colour;

// The disc of the sun or the moon, drawn twice as wide as it is. direction: length 1.
float disc(vec3 direction)
{
    const float radius = 0.0093;  // rad
    float angle = acos(min(dot(direction, light.to_sun), 1.0));
    return 1.0 - smoothstep(0.8 * radius, 1.2 * radius, angle);
}

// One star in some of the cubes into which these planes cut space around the eye.
float star(vec3 direction)
{
    vec3 place = 120.0 * direction;
    ivec3 cube = ivec3(floor(place));
    uint bits = hash(uint(cube.x) ^ hash(uint(cube.y) ^ hash(uint(cube.z))));
    if (bits > 0x02000000u) return 0.0;  // all but one in 128
    vec3 middle =
        vec3(cube) + 0.3 + 0.4 * vec3(bits & 255u, bits >> 8u & 255u, bits >> 16u & 255u) / 255.0;
    float brightness = float(bits & 15u) / 15.0;
    return brightness * brightness * (1.0 - smoothstep(0.1, 0.3, distance(place, middle)));
}

void main()
{
    vec2 place = 2.0 * gl_FragCoord.xy / vec2(camera.window_size) - 1.0;  // clip space
    vec3 sight =
        vec3(place / vec2(camera.projection[0][0], camera.projection[1][1]), -1.0);  // eye space
    vec3 direction = normalize(transpose(mat3(camera.view)) * sight);
    vec3 radiance;
    float way;  // m through snowy air
    if (direction.y < 0.0) {
        // To the snow on the ground; at the horizon as far as numbers are good for.
        way = min(max(camera.eye.y - camera.field_depth, 0.0) / -direction.y, 1.0e5);
        float white = smoothstep(0.0, 0.02, camera.field_depth);
        vec3 field = mix(vec3(0.20, 0.21, 0.17), vec3(0.90, 0.93, 0.97), white);
        radiance = lit(field, vec3(0.0, 1.0, 0.0), camera.eye + way * direction);
    } else {
        const float clouds = 12.0;  // m above the eye: from there the snow comes
        way = min(clouds / max(direction.y, 1e-3), 1000.0);
        radiance = mix(light.zenith, air_light(direction), exp(-6.0 * direction.y));
        radiance += 20.0 * disc(direction) * light.sun;
        if (light.stars > 0.0) radiance += light.stars * star(direction);
    }
    colour = vec4(tone_mapped(through_air(radiance, camera.eye + way * direction)), 1.0);
}
