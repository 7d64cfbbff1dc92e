#include "common/scene/scene.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <iostream>
#include <sstream>

#include "common/scene/obj.hpp"
#include "common/scene/orientation.hpp"
#include "common/scene/polygon.hpp"

namespace {

using glm::dvec3;
using glm::vec3;

// Where the points lie in the world, and by what the scene was scaled for that.
struct Fitted {
    std::vector<vec3> points;
    double factor;
};

// Moves and scales the scene into its box. In double precision, as its coordinates may be large and
// differ little: those of maps count from the equator.
Fitted fit(const std::filesystem::path& path, const Obj& obj, char up)
{
    const auto turn = [&](dvec3 p) { return up == 'z' ? dvec3(p.x, p.z, -p.y) : p; };
    dvec3 least(INFINITY), most(-INFINITY);
    for (const Polygon& polygon : obj.polygons) {
        for (const uint32_t corner : polygon.corners) {
            least = glm::min(least, turn(obj.points[corner]));
            most = glm::max(most, turn(obj.points[corner]));
        }
    }
    const dvec3 room(16, 6, 16), size = most - least;  // m
    const double largest = std::max({size.x, size.y, size.z});
    if (largest == 0) refuse_scene(path, "all its vertices are one point");
    if (!(largest > 1e-30 && largest < 1e30)) {
        std::ostringstream reason;
        reason << "it is " << largest << " across, not within 1e-30 and 1e30";
        refuse_scene(path, reason.str());
    }
    double factor = INFINITY;
    for (int axis = 0; axis < 3; ++axis) {
        if (size[axis] > 0) factor = std::min(factor, room[axis] / size[axis]);
    }
    const dvec3 foot(0.5 * (least.x + most.x), least.y, 0.5 * (least.z + most.z));
    Fitted fitted{{}, factor};
    for (const dvec3& point : obj.points) fitted.points.emplace_back(factor * (turn(point) - foot));
    return fitted;
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
    Obj obj = read_obj(path);
    if (obj.polygons.empty()) refuse_scene(path, "it has no faces (is it a Wavefront OBJ file?)");
    const auto [points, factor] = fit(path, obj, up);
    obj.materials.print_warnings();
    orient(obj.polygons, points);

    Scene scene;
    std::vector<vec3> light;  // of each vertex
    for (const Polygon& polygon : obj.polygons) {
        const Material& material = obj.materials[polygon.material];
        std::vector<dvec3> corners;
        for (const uint32_t corner : polygon.corners) corners.push_back(points[corner]);
        for (const size_t i : cut_into_triangles(corners)) {
            const vec3 colour =
                polygon.material == 0 ? obj.colours[polygon.corners[i]] : material.colour;
            scene.vertices.push_back({corners[i], {}, colour});
            light.push_back(material.light);
        }
    }
    compute_normals(scene.vertices);
    for (size_t i = 0; i < light.size(); ++i) {
        if (light[i] == vec3(0)) continue;
        scene.lamps.push_back(scene.vertices[i]);
        scene.lamps.back().colour = light[i];
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
