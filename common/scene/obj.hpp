// Wavefront OBJ files: the surfaces and their materials; all else in them is passed over.
#pragma once

#include <cstdint>
#include <filesystem>
#include <glm/glm.hpp>
#include <stdexcept>
#include <string>
#include <vector>

#include "common/scene/materials.hpp"

struct Corner {
    static constexpr uint32_t none = UINT32_MAX;
    uint32_t point;                     // which, counted from 0
    uint32_t uv = none, normal = none;  // the same, where the file has them
};

struct Polygon {
    std::vector<Corner> corners;  // at least three
    size_t material = 0;          // its number
    uint32_t smoothing = 0;       // smooth where it meets others of this group; 0: flat
};

struct Obj {
    std::vector<glm::dvec3> points;  // as in the file
    std::vector<glm::vec3> colours;  // of each point: what has no material is drawn in them
    std::vector<glm::vec2> uvs;      // texture coordinates
    std::vector<glm::vec3> normals;  // of any length
    std::vector<Polygon> polygons;
    Materials materials;
};

// Throws std::runtime_error naming file and line.
Obj read_obj(const std::filesystem::path& path);

// Throws std::runtime_error naming the scene.
[[noreturn]] inline void refuse_scene(const std::filesystem::path& path, const std::string& reason)
{
    throw std::runtime_error("cannot use scene " + path.string() + ": " + reason);
}
