#include "common/scene/obj.hpp"

#define TINYOBJLOADER_IMPLEMENTATION
#define TINYOBJLOADER_USE_DOUBLE  // coordinates of maps are large and differ little
#include <tiny_obj_loader.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/gtc/type_ptr.hpp>
#include <iostream>
#include <map>
#include <sstream>
#include <stdexcept>

#include "common/files.hpp"

namespace fs = std::filesystem;
using glm::dvec3;
using glm::vec3;

namespace {

void warn(const fs::path& path, const std::string& loss)
{
    std::cerr << "warning: " << path.string() << ": " << loss << "; faces are grey" << std::endl;
}

// The text of an OBJ or MTL file as the library understands it: without byte order mark,
// comments behind numbers, blanks and backslashes in names, and lines that end in a backslash.
// Appends to `mtl` the same of the MTL files that it names.
std::string read_statements(const fs::path& path, std::string* mtl)
{
    std::string text = read_file(path), line, statement, line_ends, result;
    if (text.starts_with("\xEF\xBB\xBF")) text.erase(0, 3);
    std::istringstream lines(text);
    for (int number = 1; std::getline(lines, line); ++number) {
        statement += line.substr(0, line.find_last_not_of(" \t\r") + 1);
        line_ends += '\n';  // as many as the statement has, and the next keeps its number
        if (statement.ends_with('\\') && statement[0] != '#') {
            statement.back() = ' ';
            continue;
        }
        std::replace(statement.begin(), statement.end(), '\\', '/');
        const std::string keyword = statement.substr(0, statement.find_first_of(" \t"));
        std::string rest = statement.substr(keyword.size());
        rest.erase(0, rest.find_first_not_of(" \t"));
        if (keyword == "v" || keyword == "f") rest.erase(std::min(rest.find('#'), rest.size()));
        if (keyword == "v" && rest.find_first_not_of("+-.0123456789eE \t") != rest.npos)
            throw std::runtime_error("line " + std::to_string(number) + " has no numbers: " + rest);
        if (keyword.ends_with("mtl")) std::replace(rest.begin(), rest.end(), ' ', '_');  // names
        if (mtl != nullptr && keyword == "mtllib") {
            const fs::path file = path.parent_path() / path_of(rest);
            if (!fs::is_regular_file(file)) warn(path, "there is no " + file.string());
            if (fs::is_regular_file(file)) *mtl += read_statements(file, nullptr);
        }
        result += keyword + ' ' + rest + line_ends;
        statement = line_ends = "";
    }
    return result;
}

// folder: that of its pictures.
Material to_material(const tinyobj::material_t& from, const fs::path& folder)
{
    const std::string &picture = from.diffuse_texname, &mask = from.alpha_texname;
    Material material;
    material.colour = glm::clamp(glm::make_vec3(from.diffuse), 0.0, 1.0);
    material.light = glm::clamp(glm::make_vec3(from.emission), 0.0, 1000.0);  // white paper: 1
    if (!picture.empty()) material.picture = folder / path_of(picture);
    if (!mask.empty()) material.mask = folder / path_of(mask);
    material.uv_scale = glm::vec2(glm::make_vec3(from.diffuse_texopt.scale));
    material.uv_offset = glm::vec2(glm::make_vec3(from.diffuse_texopt.origin_offset));
    // Many write black where the picture has the colour.
    if (material.colour == vec3(0) && !picture.empty()) material.colour = vec3(1);
    return material;
}

// The vector at an index of the library's plain numbers; `otherwise` if the index is none of them.
template <typename Vector>
Vector read(const std::vector<double>& numbers, int index, Vector otherwise)
{
    const size_t first = size_t(Vector::length()) * size_t(index);
    if (first < numbers.size()) std::copy_n(&numbers[first], Vector::length(), &otherwise[0]);
    return otherwise;
}

}  // namespace

Obj read_obj(const fs::path& path, char up)
{
    std::string mtl, warnings, errors;
    const std::string statements = read_statements(path, &mtl);
    std::istringstream obj_stream(statements), mtl_stream(mtl);
    tinyobj::MaterialStreamReader mtl_reader(mtl_stream);
    tinyobj::attrib_t file;
    std::vector<tinyobj::shape_t> shapes;
    std::vector<tinyobj::material_t> materials;
    if (!tinyobj::LoadObj(&file, &shapes, &materials, &warnings, &errors, &obj_stream, &mtl_reader,
                          false, false))  // no triangles, and no colours where the file has none
        throw std::runtime_error(errors.substr(0, errors.find('\n')) + " (export it again)");
    if (const size_t lost = warnings.find("material ["); lost != warnings.npos)
        warn(path, warnings.substr(lost, warnings.find('\n', lost) - lost));
    if (!mtl.empty() && statements.find("usemtl ") == statements.npos)
        warn(path, "it uses none of its materials");

    Obj obj{0, dvec3(INFINITY), dvec3(-INFINITY), {}, {Material()}};
    if (!file.colors.empty()) obj.materials[0].colour = vec3(1);
    for (const tinyobj::material_t& material : materials)
        obj.materials.push_back(to_material(material, path.parent_path()));
    const auto turn = [up](dvec3 v) { return up == 'z' ? dvec3(v.x, v.z, -v.y) : v; };
    std::map<std::array<double, 3>, size_t> indices;
    for (const auto& [name, mesh, paths, dots] : shapes) {
        auto corner = mesh.indices.begin();
        for (size_t i = 0; i < mesh.num_face_vertices.size(); ++i) {
            Polygon polygon{{}, size_t(mesh.material_ids[i] + 1), mesh.smoothing_group_ids[i]};
            const Material& material = obj.materials[polygon.material];
            for (const auto end = corner + mesh.num_face_vertices[i]; corner != end; ++corner) {
                const auto [at, normal_at, uv_at] = *corner;
                const dvec3 point = turn(read(file.vertices, at, dvec3(NAN))),
                            normal = turn(read(file.normals, normal_at, dvec3(0)));
                const vec3 colour = glm::clamp(read(file.colors, at, dvec3(1)), 0.0, 1.0);
                const glm::vec2 uv = read(file.texcoords, uv_at, glm::dvec2(0));
                if (std::isnan(point.x)) throw std::runtime_error("a face has an unknown vertex");
                const Vertex vertex{vec3(0), normal, material.colour * colour,
                                    material.uv_scale * uv + material.uv_offset};
                const auto index = indices.insert({{point.x, point.y, point.z}, indices.size()});
                polygon.corners.push_back({index.first->second, point, vertex});
                obj.least = glm::min(obj.least, point);
                obj.most = glm::max(obj.most, point);
            }
            obj.polygons.push_back(std::move(polygon));
        }
        if (corner != mesh.indices.end())  // the library counts those of a face in one byte
            throw std::runtime_error("a face has more than 255 corners (export it as triangles)");
    }
    obj.points = indices.size();
    if (obj.polygons.empty()) throw std::runtime_error("it has no faces: export it as polygons");
    return obj;
}
