#include "common/scene/materials.hpp"

#include <algorithm>
#include <optional>
#include <stdexcept>
#include <system_error>

#include "common/harness/files.hpp"

namespace fs = std::filesystem;

namespace {

using glm::dvec3;
using glm::vec3;

// The file `name` in `folder`, or one whose name differs from it in capitals only.
std::optional<fs::path> find_similar(fs::path folder, std::string name)
{
    std::replace(name.begin(), name.end(), '\\', '/');
    std::error_code error;
    for (const fs::path& part : path_of(name)) {
        fs::path next = folder / part;
        if (!fs::exists(next, error)) {
            const auto is_similar = [&](const fs::path& file) {
                return lower_case(file.filename().string()) == lower_case(part.string());
            };
            const fs::directory_iterator files(folder.empty() ? "." : folder, error), end;
            const auto file = std::find_if(files, end, is_similar);
            if (file == end) return {};
            next = folder / file->path().filename();
        }
        folder = next;
    }
    if (!fs::exists(folder, error) || fs::is_directory(folder, error)) return {};
    return folder;
}

// The same, for a name that may have folders of another machine in front of it.
std::optional<fs::path> find_named(const fs::path& folder, std::string_view name)
try {
    const std::optional<fs::path> path = find_similar(folder, std::string(name));
    if (path) return path;
    return find_similar(folder, std::string(name.substr(name.find_last_of("/\\") + 1)));
} catch (const std::system_error&) {
    return {};  // it is no UTF-8, and no name that Windows can have
}

// The name of the picture in a statement, behind its options. Two of those show here: scale and
// offset of the texture coordinates.
std::string_view picture_name(std::string_view words, Material& material)
{
    while (words.starts_with('-')) {
        const std::string option = lower_case(take_word(words));
        if (option != "-s" && option != "-o" && option != "-t") {
            take_word(words);
            if (option == "-mm") take_word(words);
            continue;
        }
        glm::vec2 ignored;
        glm::vec2& numbers = option == "-s"   ? material.uv_scale
                             : option == "-o" ? material.uv_offset
                                              : ignored;
        for (int i = 0; i < 3; ++i) {
            std::string_view rest = words;
            const std::optional<double> number = to_number(take_word(rest));
            if (!number) break;
            if (i < 2) numbers[i] = float(glm::clamp(*number, -1e6, 1e6));
            words = rest;
        }
    }
    return words;
}

// What has no exact match is compared by this: in small letters, and without a comment.
std::string similar(std::string_view name)
{
    std::string words;
    for (auto word = take_word(name); !word.empty() && word[0] != '#'; word = take_word(name))
        words += lower_case(word) + ' ';
    return words;
}

// Three numbers, or one that stands for all three.
std::optional<dvec3> to_colour(std::string_view text)
{
    text = without_comment(text);
    dvec3 colour(0);
    int count = 0;
    while (count < 3 && !text.empty()) {
        const std::optional<double> value = to_number(take_word(text));
        if (!value) return {};
        colour[count++] = *value;
    }
    if (count == 1) return dvec3(colour[0]);
    if (count == 3) return colour;
    return {};
}

}  // namespace

void Materials::read(const Statement& mtllib)
{
    const auto read_if_found = [&](std::string_view name) {
        const std::optional<fs::path> path = find_named(scene_.parent_path(), name);
        if (path && files_.insert(*path).second) {
            try {
                read_file(*path);
            } catch (const std::runtime_error& error) {
                warnings.add(scene_, mtllib, error.what());
            }
        }
        return path.has_value();
    };
    // The whole line is one name, or each word is one.
    std::string_view names = mtllib.rest;
    if (read_if_found(names)) return;
    bool found = false;
    for (auto name = take_word(names); !name.empty() && name[0] != '#'; name = take_word(names))
        found |= read_if_found(name);
    if (!found) warnings.add(scene_, mtllib, "no such file, its materials are grey");
}

void Materials::read_file(const fs::path& path)
{
    Statements statements(path);
    Material ignored;
    Material* material = &ignored;  // the one that the statements are about
    bool has_picture = false;
    while (const std::optional<Statement> statement = statements.next()) {
        const auto set = [&](vec3& colour, double most) {
            const std::optional<dvec3> given = to_colour(statement->rest);
            if (!given) return warnings.add(path, *statement, "not a colour, ignored");
            const dvec3 inside = glm::clamp(*given, 0.0, most);
            if (*given != inside) {
                warnings.add(path, *statement,
                             "outside 0 to " + std::to_string(int(most)) + ", clamped");
            }
            colour = inside;
        };
        if (statement->keyword == "newmtl") {
            has_picture = false;
            const auto [place, is_new] =
                by_name_.emplace(std::string(statement->rest), materials_.size());
            by_similar_name_.emplace(similar(statement->rest), materials_.size());
            if (is_new) materials_.emplace_back();
            material = is_new ? &materials_.back() : &ignored;
        } else if (statement->keyword == "kd") {
            set(material->colour, 1);
            material->tint = material->colour;
        } else if (statement->keyword == "ke") {
            const double brightest = 1000;  // 1 is white paper in a bright room
            set(material->light, brightest);
        } else if (statement->keyword == "map_kd") {
            material->picture = find_picture(path, *statement, *material);
            has_picture = true;
        } else if (statement->keyword == "map_d") {
            material->mask = find_picture(path, *statement, *material);
        }
        // Many write black where the picture has the colour.
        if (has_picture && material->colour == vec3(0)) {
            material->colour = Material{}.colour;
            material->tint = Material{}.tint;
        }
    }
}

// Empty if there is none. Whether it can be used is found out where it is drawn.
fs::path Materials::find_picture(const fs::path& file, const Statement& map, Material& material)
{
    const std::string_view name = picture_name(map.rest, material);
    std::optional<fs::path> path = find_named(file.parent_path(), name);
    if (!path) path = find_named(file.parent_path(), name.substr(0, name.find(" #")));
    if (path && fs::is_regular_file(*path)) return *path;
    warnings.add(file, map, "no such picture, one colour takes its place");
    return {};
}

size_t Materials::find(const Statement& usemtl)
{
    if (const auto found = by_name_.find(usemtl.rest); found != by_name_.end())
        return found->second;
    const auto found = by_similar_name_.find(similar(usemtl.rest));
    if (found != by_similar_name_.end()) return found->second;
    warnings.add(scene_, usemtl, "no such material, grey instead");
    return 0;
}
