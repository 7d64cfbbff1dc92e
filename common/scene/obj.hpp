// Wavefront OBJ files: their polygons and materials, read by tinyobjloader.
#pragma once

#include "common/scene/scene.hpp"

struct Corner {
    size_t index;      // of its point: equal where corners meet
    glm::dvec3 point;  // in the file, but y up
    Vertex vertex;     // without a position, and with a normal of 0 where the file has none

    glm::dvec3 position() const { return vertex.position; }  // m, once the scene has its place
};

struct Polygon {
    std::vector<Corner> corners;  // at least three
    size_t material;              // index
    unsigned smoothing;           // smooth where it meets others of this group; 0: flat
};

struct Obj {
    size_t points;                    // that differ
    glm::dvec3 least, most;           // x, y and z of them
    std::vector<Polygon> polygons;    // at least one
    std::vector<Material> materials;  // the first is for polygons without one
};

// up: as for load_scene. Throws std::runtime_error.
Obj read_obj(const std::filesystem::path& path, char up);
