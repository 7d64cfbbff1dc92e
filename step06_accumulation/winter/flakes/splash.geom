#version 430 core
// A drop that has come down becomes a splash.

#include "step06_accumulation/winter/flakes/billboard.glsl"

layout(max_vertices = 16) out;

// Droplets that a drop has thrown up where it came down, `time` s ago. They fly as stones do, without drag.
void draw_splash(vec3 position, float time, float diameter, uint index)
{
    for (uint droplet = 0u; droplet < 4u; ++droplet) {
        uint bits = hash(4u * index + droplet);
        vec3 random = vec3(bits & 255u, (bits >> 8u) & 255u, (bits >> 16u) & 255u) / 255.0;
        float angle = 6.2831853 * (float(droplet) + random.x) / 4.0;
        float speed = 0.2 + 0.4 * random.y;  // m/s, along the ground
        vec3 start = vec3(speed * cos(angle), 0.6 + 0.6 * random.z, speed * sin(angle));
        vec3 way = start * time + 0.5 * weather.gravity * time * time;
        if (way.y < 0.0) continue;  // down again
        vec3 velocity = start + weather.gravity * time;
        draw(position + way, velocity, min(frame.shutter, time), diameter, 2.0, mat2(1.0));
    }
}

void main()
{
    float rest = flake[0].rest;
    if (rest > 0.0) draw_splash(flake[0].position, rest, 0.8 * diameter(flake[0].index, weather), flake[0].index);
}
