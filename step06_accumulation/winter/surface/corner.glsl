// A corner of a triangle of the scene, before snow lifts it: what it has in snow_surface.hpp.

struct Corner {
    vec3 position;  // m
    vec3 normal;
    vec3 colour;
    vec2 uv;
    float lift;
    float skirt;
    vec4 even;
};
