// A corner of a triangle of the scene, before snow lifts it: a SurfaceVertex of snow_surface.hpp.

struct Corner {
    vec3 position;  // m
    vec3 normal;
    vec3 colour;
    vec2 uv;
    float displacement;  // 1: moves with the snow, 0: stays
    float skirt;
    vec3 even_normal;
};
