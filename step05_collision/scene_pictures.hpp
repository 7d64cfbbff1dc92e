// The pictures on the surfaces of a scene, as textures.
#pragma once

#include <filesystem>
#include <map>
#include <utility>
#include <vector>

#include "common/program.hpp"
#include "common/scene/scene.hpp"

class ScenePictures {
public:
    // Loads those of all submeshes, each once. What cannot be used is told on stderr in a line, and
    // its material's colour takes its place.
    explicit ScenePictures(const Scene& scene);

    // Gives that of a submesh, by its number, to the program in use (picture.glsl); one past the
    // last is none.
    void set(Program& program, size_t submesh) const;

private:
    GLuint load(const Material& material);

    // By the files of picture and mask.
    std::map<std::pair<std::filesystem::path, std::filesystem::path>, GlObject> loaded_;
    GlObject white_;
    std::vector<GLuint> of_submesh_;
};
