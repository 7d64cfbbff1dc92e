// Scenes for the tests, written and loaded.
#pragma once

#include <gtest/gtest.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>
#include <iostream>
#include <sstream>
#include <string>

#include "common/scene/scene.hpp"

class SceneFile : public testing::Test {
protected:
    void SetUp() override
    {
        folder = std::filesystem::path(testing::TempDir()) /
                 ("snowfall_scene_" + std::to_string(getpid()));
        std::filesystem::create_directories(folder);
    }
    void TearDown() override { std::filesystem::remove_all(folder); }

    void write(const std::string& name, const std::string& text) const
    {
        std::filesystem::create_directories((folder / name).parent_path());
        std::ofstream(folder / name, std::ios::binary) << text;
    }

    // What is said on stderr is left in `warnings`.
    Scene load(const std::string& text, char up = 'y')
    {
        write("scene.obj", text);
        return load_file(folder / "scene.obj", up);
    }

    Scene load_file(const std::filesystem::path& path, char up = 'y')
    {
        std::ostringstream said;
        std::streambuf* const before = std::cerr.rdbuf(said.rdbuf());
        try {
            Scene scene = load_scene(path, up);
            std::cerr.rdbuf(before);
            warnings = said.str();
            return scene;
        } catch (...) {
            std::cerr.rdbuf(before);
            throw;
        }
    }

    // The message with which the scene is refused; empty if it is not.
    std::string refusal(const std::string& text)
    {
        try {
            load(text);
        } catch (const std::runtime_error& error) {
            return error.what();
        }
        return "";
    }

    std::filesystem::path folder;
    std::string warnings;
};

// 16 m wide, as wide as the world allows: it is not scaled.
inline const std::string square = "v -8 0 -8\nv -8 0 8\nv 8 0 8\nv 8 0 -8\n";

// m2, and as seen from above
inline double area(const Scene& scene, bool seen_from_above = false)
{
    double sum = 0;
    for (size_t i = 0; i < scene.indices.size(); i += 3) {
        const glm::vec3 a = scene.corner(i).position;
        const glm::vec3 across =
            glm::cross(scene.corner(i + 1).position - a, scene.corner(i + 2).position - a);
        sum += 0.5 * (seen_from_above ? across.y : glm::length(across));
    }
    return sum;
}
