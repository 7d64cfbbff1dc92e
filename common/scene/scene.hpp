// Scenes from OBJ files: fitted into the world, as triangles that share their corners.
#pragma once

#include <cstdint>
#include <filesystem>
#include <glm/glm.hpp>
#include <vector>

#include "common/terrain.hpp"

struct Vertex {
    glm::vec3 position;  // m, world space
    glm::vec3 normal;    // of the surface, length 1
    glm::vec3 colour;    // diffuse, linear; multiplies the picture where there is one
    glm::vec2 uv;        // texture coordinates
};

struct Material {
    glm::vec3 colour{0.5f};               // diffuse (Kd), linear, 0 to 1
    glm::vec3 light{0};                   // what it shines by itself (Ke)
    std::filesystem::path picture, mask;  // on it (map_Kd), and cut out of it (map_d); or empty
    glm::vec2 uv_scale{1}, uv_offset{0};  // for the texture coordinates of both
};

// The triangles of one material, which can be drawn at once.
struct Submesh {
    Material material;
    size_t first, count;  // of the scene's indices
};

// How coordinates of a file become those of the world: p is factor * (p - foot), y up.
struct Placement {
    double factor = 1;
    glm::dvec3 foot{0};
};

struct Scene {
    std::vector<Vertex> vertices;   // each once, however many triangles have a corner there
    std::vector<uint32_t> indices;  // three make a triangle, counter-clockwise from outside
    std::vector<Submesh> submeshes;
    Placement placement;

    const Vertex& corner(size_t i) const { return vertices[indices[i]]; }
};

// Fits the scene into a box 16 m wide and deep and 6 m high, its floor on y = 0 and its middle on
// the y axis. in_metres: it keeps its size. up: the axis that points up in the file, 'y' or 'z'.
// other: it comes to lie where it lies to that scene in the files. The path "none" is the empty
// scene. Throws std::runtime_error naming the file.
Scene load_scene(const std::filesystem::path& path, char up, const Placement* other = nullptr,
                 bool in_metres = false);

// How high the scene stands: clouds hang above it, and the tour flies over it.
Terrain terrain_of(const Scene& scene);
