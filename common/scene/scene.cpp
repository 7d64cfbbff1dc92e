#include "common/scene/scene.hpp"

#include <tiny_obj_loader.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <iostream>
#include <sstream>
#include <stdexcept>

#include "common/harness/files.hpp"
#include "common/scene/polygon.hpp"

namespace {

using glm::vec3;

[[noreturn]] void refuse(const std::filesystem::path& path, const std::string& reason)
{
    throw std::runtime_error("cannot use scene " + path.string() + ": " + reason);
}

// What tinyobjloader lets pass in silence: a vertex of fewer than three finite numbers, which it
// reads as zeros, a face of fewer than three corners, which it drops, and one of more than 255,
// whose corners it miscounts.
void check_lines(const std::filesystem::path& path, const std::string& text)
{
    if (text.find('\0') != std::string::npos) refuse(path, "not a text file");
    std::istringstream lines(text);
    std::string line, keyword, word;
    for (int number = 1; std::getline(lines, line); ++number) {
        const size_t first = std::min(line.find_first_not_of(" \t"), line.size());
        const std::string start = line.substr(first, 2);
        if (start != "v " && start != "v\t" && start != "f " && start != "f\t") continue;
        std::istringstream words(line);
        words >> keyword;
        int count = 0;
        while (words >> word) {
            if (keyword == "v" && count < 3) {
                char* end = nullptr;
                const float value = std::strtof(word.c_str(), &end);
                if (*end != '\0' || !std::isfinite(value)) {
                    refuse(path,
                           "line " + std::to_string(number) + ": '" + word + "' is no coordinate");
                }
            }
            ++count;
        }
        if (count < 3) {
            refuse(path, "line " + std::to_string(number) + ": " + std::to_string(count) +
                             (keyword == "v" ? " coordinates" : " corners") +
                             ", at least 3 are needed");
        }
        if (keyword == "f" && count > 255) {
            refuse(path, "line " + std::to_string(number) + ": " + std::to_string(count) +
                             " corners, at most 255 can be read");
        }
    }
}

// Moves and scales the scene into its box. Returns the factor.
float fit(const std::filesystem::path& path, std::vector<Vertex>& vertices)
{
    const vec3 room(16, 6, 16);  // m
    vec3 least = vertices.front().position, most = least;
    for (const Vertex& vertex : vertices) {
        least = glm::min(least, vertex.position);
        most = glm::max(most, vertex.position);
    }
    const vec3 size = most - least;
    if (std::max({size.x, size.y, size.z}) == 0) refuse(path, "all its vertices are one point");
    float factor = INFINITY;
    for (int axis = 0; axis < 3; ++axis) {
        if (size[axis] > 0) factor = std::min(factor, room[axis] / size[axis]);
    }
    const vec3 foot(0.5f * (least.x + most.x), least.y, 0.5f * (least.z + most.z));
    for (Vertex& vertex : vertices) vertex.position = factor * (vertex.position - foot);
    return factor;
}

void compute_normals(std::vector<Vertex>& vertices)
{
    for (size_t i = 0; i < vertices.size(); i += 3) {
        const vec3 a = vertices[i].position, b = vertices[i + 1].position,
                   c = vertices[i + 2].position;
        const vec3 across = glm::cross(b - a, c - a);
        const float length = glm::length(across);
        const vec3 normal = length > 0 ? across / length : vec3(0, 1, 0);
        for (size_t corner = i; corner < i + 3; ++corner) vertices[corner].normal = normal;
    }
}

}  // namespace

Scene load_scene(const std::filesystem::path& path, char up)
{
    if (path == "none") return {};
    const std::string text = read_file(path);
    check_lines(path, text);

    std::istringstream lines(text);
    tinyobj::MaterialFileReader materials_reader(path.parent_path().string() + "/");
    tinyobj::attrib_t attributes;
    std::vector<tinyobj::shape_t> shapes;
    std::vector<tinyobj::material_t> materials;
    std::string warning, error;
    constexpr bool triangulate = false;  // it does so wrongly where corners point inwards
    if (!tinyobj::LoadObj(&attributes, &shapes, &materials, &warning, &error, &lines,
                          &materials_reader, triangulate)) {
        refuse(path, error.substr(0, error.find('\n')));
    }

    const auto position = [&](tinyobj::index_t corner) {
        const int index = corner.vertex_index;
        if (index < 0 || 3 * size_t(index) + 2 >= attributes.vertices.size()) {
            refuse(path, "a face names vertex " + std::to_string(index + 1) + " of " +
                             std::to_string(attributes.vertices.size() / 3));
        }
        const float* xyz = &attributes.vertices[3 * size_t(index)];
        return up == 'z' ? vec3(xyz[0], xyz[2], -xyz[1]) : vec3(xyz[0], xyz[1], xyz[2]);
    };
    Scene scene;
    std::vector<vec3> emission;  // of each vertex
    for (const tinyobj::shape_t& shape : shapes) {
        const tinyobj::mesh_t& mesh = shape.mesh;
        auto first = mesh.indices.begin();
        for (size_t face = 0; face < mesh.num_face_vertices.size(); ++face) {
            std::vector<glm::dvec3> corners(mesh.num_face_vertices[face]);
            std::transform(first, first + std::ptrdiff_t(corners.size()), corners.begin(),
                           position);
            first += std::ptrdiff_t(corners.size());
            Vertex vertex{};
            const int material = mesh.material_ids[face];
            vertex.colour = vec3(0.5f);
            vec3 own_light(0);
            if (material >= 0) {
                const tinyobj::real_t* diffuse = materials[size_t(material)].diffuse;
                vertex.colour = {diffuse[0], diffuse[1], diffuse[2]};
                const tinyobj::real_t* own = materials[size_t(material)].emission;
                own_light = {own[0], own[1], own[2]};
            }
            for (const size_t corner : cut_into_triangles(corners)) {
                vertex.position = corners[corner];
                scene.vertices.push_back(vertex);
                emission.push_back(own_light);
            }
        }
    }
    if (scene.vertices.empty()) refuse(path, "it has no faces (is it a Wavefront OBJ file?)");
    const float factor = fit(path, scene.vertices);
    compute_normals(scene.vertices);
    for (size_t i = 0; i < emission.size(); ++i) {
        if (emission[i] == vec3(0)) continue;
        scene.lamps.push_back(scene.vertices[i]);
        scene.lamps.back().colour = emission[i];
    }
    std::cout << "scene " << path.filename().string() << ": " << scene.vertices.size() / 3
              << " triangles, scaled by " << factor << std::endl;
    return scene;
}

SceneMesh::SceneMesh(const std::vector<Vertex>& vertices)
    : buffer_(make_buffer()), vao_(make_vertex_array()), count_(GLsizei(vertices.size()))
{
    glBindVertexArray(vao_);
    glBindBuffer(GL_ARRAY_BUFFER, buffer_);
    glBufferData(GL_ARRAY_BUFFER, GLsizeiptr(vertices.size() * sizeof(Vertex)), vertices.data(),
                 GL_STATIC_DRAW);
    const auto field = [](GLuint location, GLint floats, size_t offset) {
        glEnableVertexAttribArray(location);
        glVertexAttribPointer(location, floats, GL_FLOAT, GL_FALSE, sizeof(Vertex),
                              reinterpret_cast<const void*>(offset));
    };
    field(0, 3, offsetof(Vertex, position));
    field(1, 3, offsetof(Vertex, normal));
    field(2, 3, offsetof(Vertex, colour));
}

void SceneMesh::draw() const
{
    glBindVertexArray(vao_);
    glDrawArrays(GL_TRIANGLES, 0, count_);
}
