#version 430 core
// As surface.frag, and crystals at the surface of the snow flash in the sun.

#include "common/snow.glsl"
#include "step06_accumulation/winter/surface/look.glsl"

out vec4 colour;

// Uniform in [0, 1), one number for each square of the plane.
float random_of(ivec2 square)
{
    return float(hash(uint(square.x) ^ hash(uint(square.y))) >> 8u) * (1.0 / 16777216.0);
}

// Light that they mirror into the eye. There is one in each square, as large as some pixels and turned at
// random; few are turned so that they flash.
vec3 glint(Look look)
{
    vec3 to_eye = camera.eye - place.world;
    float away = max(length(to_eye), 0.001);
    // Squares of 4 mm, or twice, four times ... as wide, so that they stay larger than a pixel.
    float pixel = 2.0 * away / (camera.projection[1][1] * float(camera.window_size.y));  // m
    float square = 0.004 * exp2(max(ceil(log2(1.5 * pixel / 0.004)), 0.0));
    ivec2 here = ivec2(floor(place.world.xz / square));
    vec3 turn = vec3(random_of(here), random_of(here + 7919), random_of(here - 7919)) - 0.5;
    vec3 crystal = look.normal + 1.2 * turn, halfway = light.to_sun + to_eye / away;  // neither may be 0
    float mirrored = dot(crystal, halfway) / max(length(crystal) * length(halfway), 0.001);
    return 4.0 * smoothstep(0.997, 1.0, mirrored) * exp(-0.06 * away) * look.sunlight * light.sun;
}

void main()
{
    Look look = look_at_surface();
    vec3 radiance = light_from(look);
    if (look.cover > 0.5) radiance += glint(look);
    colour = vec4(air.rgb + air.a * radiance, 1.0);
}
