// Any bytes as a scene with a material file, for the tests that look for those that break it.
#pragma once

#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <sstream>
#include <string>
#include <string_view>

#include "common/scene/scene.hpp"

// A scene must be finite and lie in its box, or be refused in one line: otherwise this says so and
// aborts. Up to the first zero byte `bytes` are the OBJ file, behind it those of "m.mtl".
class SceneInput {
public:
    SceneInput()
        : folder_(std::filesystem::temp_directory_path() /
                  ("snowfall_fuzz_" + std::to_string(getpid())))
    {
        std::filesystem::create_directories(folder_);
    }
    ~SceneInput() { std::filesystem::remove_all(folder_); }
    SceneInput(const SceneInput&) = delete;
    SceneInput& operator=(const SceneInput&) = delete;

    void load(std::string_view bytes) const
    {
        const size_t end = std::min(bytes.find('\0'), bytes.size());
        write("scene.obj", bytes.substr(0, end));
        write("m.mtl", bytes.substr(std::min(end + 1, bytes.size())));
        std::ostringstream said;
        std::streambuf *const out = std::cout.rdbuf(said.rdbuf()), *const err = std::cerr.rdbuf(
                                                                       said.rdbuf());
        std::string fault;
        try {
            fault = fault_of(load_scene(folder_ / "scene.obj", 'y'));
        } catch (const std::runtime_error& refusal) {
            fault = fault_of(refusal.what());
        }
        std::cout.rdbuf(out);
        std::cerr.rdbuf(err);
        if (fault.empty()) return;
        std::cerr << "a scene with " << fault << ":\n" << bytes << std::endl;
        std::abort();
    }

private:
    void write(const char* name, std::string_view bytes) const
    {
        std::ofstream(folder_ / name, std::ios::binary) << bytes;
    }

    static std::string fault_of(const std::string& refusal)
    {
        return refusal.empty() || refusal.find('\n') != refusal.npos ? "no line of refusal" : "";
    }

    static std::string fault_of(const Scene& scene)
    {
        if (scene.indices.empty() || scene.indices.size() % 3 != 0) return "no whole triangles";
        for (const uint32_t index : scene.indices) {
            if (index >= scene.vertices.size()) return "a corner without a vertex";
        }
        for (const Vertex& vertex : scene.vertices) {
            const glm::vec3 p = vertex.position;
            const float rounding = 1e-4f;  // m
            const bool inside = std::abs(p.x) <= 8 + rounding && std::abs(p.z) <= 8 + rounding &&
                                p.y >= 0 && p.y <= 6 + rounding;
            if (!inside) return "a vertex outside its box";
            if (!(std::abs(glm::length(vertex.normal) - 1) < 1e-3f)) return "a wrong normal";
            const glm::vec3 c = vertex.colour;
            if (!(glm::min(c.r, glm::min(c.g, c.b)) >= 0 && glm::max(c.r, glm::max(c.g, c.b)) <= 1))
                return "a wrong colour";
            if (!std::isfinite(vertex.uv.x + vertex.uv.y)) return "a wrong texture coordinate";
        }
        size_t drawn = 0;
        for (const Submesh& submesh : scene.submeshes) {
            if (submesh.first != drawn || submesh.count == 0) return "a gap between submeshes";
            drawn += submesh.count;
            const glm::vec3 c = submesh.material.light;
            if (!(c.r >= 0 && c.g >= 0 && c.b >= 0 && c.r + c.g + c.b <= 3000))
                return "a wrong light";
        }
        if (drawn != scene.indices.size()) return "triangles in no submesh";
        return "";
    }

    std::filesystem::path folder_;
};
