#version 430 core
// A drop that has come down becomes a splash.

#include "step06_accumulation/winter/flakes/billboard.glsl"

layout(max_vertices = 16) out;

// The drop has thrown up droplets, which fly as stones do, without drag.
void main()
{
    float time = flake[0].rest;  // s, since it came down
    if (time <= 0.0) return;
    for (uint droplet = 0u; droplet < 4u; ++droplet) {
        uint bits = hash(4u * flake[0].index + droplet);
        vec3 random = vec3(bits & 255u, (bits >> 8u) & 255u, (bits >> 16u) & 255u) / 255.0;
        float angle = 6.2831853 * (float(droplet) + random.x) / 4.0;
        float speed = 0.2 + 0.4 * random.y;  // m/s, along the ground
        vec3 start = vec3(speed * cos(angle), 0.6 + 0.6 * random.z, speed * sin(angle));
        vec3 way = start * time + 0.5 * weather.gravity * time * time;
        if (way.y < 0.0) continue;  // down again
        vec3 velocity = start + weather.gravity * time;
        float size = 0.8 * diameter(flake[0].index, weather);
        draw(flake[0].position + way, velocity, min(frame.shutter, time), size, 2.0, mat2(1.0));
    }
}
