// Scenes from OBJ files: fitted into the world, as triangles that share their corners.
#pragma once

#include <cstdint>
#include <filesystem>
#include <glm/glm.hpp>
#include <vector>

#include "common/scene/materials.hpp"

struct Vertex {
    glm::vec3 position;  // m, world space
    glm::vec3 normal;    // of the surface, length 1
    glm::vec3 colour;    // diffuse, linear; multiplies the picture where there is one
    glm::vec2 uv;        // texture coordinates
};

// The triangles of one material, which can be drawn at once. Its picture is none where they have no
// texture coordinates.
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

    // Of all triangles one after the other, three each.
    const Vertex& corner(size_t i) const { return vertices[indices[i]]; }
};

// Reads `path` and scales the scene to fit a box 16 m wide and deep and 6 m high, below the clouds;
// its floor comes to lie on y = 0 and its middle on the y axis. Says by what factor. in_metres: its
// coordinates are metres, and it stays as large as it is. `up` is the axis, 'y' or 'z', that points
// up in the file. Polygons with more than three corners are divided; sheets face up and bodies
// outwards, whichever way the file has them; what has no normals and is in no smoothing group is
// flat, what has no colour is grey, and what gets lost is told on stderr. The path "none" is the
// empty scene. With the placement of another scene it comes to lie where it lies to that in the
// files. Throws std::runtime_error naming file and line.
Scene load_scene(const std::filesystem::path& path, char up, const Placement* other = nullptr,
                 bool in_metres = false);
