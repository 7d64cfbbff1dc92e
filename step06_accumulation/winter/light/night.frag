#version 430 core
// The sky when the stars are out.

#include "common/snow.glsl"
#include "step06_accumulation/winter/light/sun.glsl"

in vec3 sight;
in vec3 radiance;
in float clear;

out vec4 colour;

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
    vec3 direction = normalize(sight);
    colour = vec4(radiance + clear * (disc(direction) + light.stars * star(direction)), 1.0);
}
