// Wavefront OBJ files: the surfaces and their materials; all else in them is passed over.
#pragma once

#include <cstdint>
#include <filesystem>
#include <glm/glm.hpp>
#include <stdexcept>
#include <string>
#include <vector>

#include "common/scene/materials.hpp"

struct Polygon {
    std::vector<uint32_t> corners;  // at least three: which points, counted from 0
    size_t material;                // its number
};

struct Obj {
    std::vector<glm::dvec3> points;  // as in the file
    std::vector<glm::vec3> colours;  // of each point: what has no material is drawn in them
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
