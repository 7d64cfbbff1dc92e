// The materials of a scene, from the MTL files that it names.
#pragma once

#include <filesystem>
#include <glm/glm.hpp>
#include <map>
#include <set>
#include <string>
#include <string_view>
#include <vector>

#include "common/scene/statements.hpp"
#include "common/scene/warnings.hpp"

struct Material {
    glm::vec3 colour{0.5f};         // diffuse (Kd), linear, 0 to 1; grey where there is none
    glm::vec3 light{0};             // what it shines by itself (Ke)
    std::filesystem::path picture;  // on its surfaces (map_Kd); empty: none
    glm::vec3 tint{1};              // what that is multiplied by: Kd as well, unless it is black
    std::filesystem::path mask;     // of what is cut out of it (map_d); empty: none
    glm::vec2 uv_scale{1}, uv_offset{0};  // for the texture coordinates of both

    bool has_picture() const { return !picture.empty() || !mask.empty(); }
};

// Without its materials a scene is grey, but no worse. So nothing is refused here: what gets lost
// is told.
class Materials {
public:
    explicit Materials(const std::filesystem::path& scene) : scene_(scene) {}

    // Reads the files that the statement names, relative to the scene's folder. Their names, and
    // those of pictures, may have blanks, \ for /, and capitals where the file has small letters.
    void read(const Statement& mtllib);

    // The number of the material that the statement names; 0, plain grey, if there is none.
    size_t find(const Statement& usemtl);

    const Material& operator[](size_t number) const { return materials_[number]; }

    Warnings warnings;  // those of the scene itself, too

private:
    void read_file(const std::filesystem::path& path);
    std::filesystem::path find_picture(const std::filesystem::path& file, const Statement& map,
                                       Material& material);

    std::filesystem::path scene_;
    std::vector<Material> materials_{Material{}};
    std::map<std::string, size_t, std::less<>> by_name_, by_similar_name_;
    std::set<std::filesystem::path> files_;  // those that were read
};
