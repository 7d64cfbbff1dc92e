#include "common/scene/scene.hpp"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <iostream>
#include <sstream>
#include <string_view>
#include <unordered_map>
#include <utility>

#include "common/scene/normals.hpp"
#include "common/scene/obj.hpp"
#include "common/scene/orientation.hpp"
#include "common/scene/polygon.hpp"

namespace {

using glm::dvec3;
using glm::vec2;
using glm::vec3;

dvec3 turn(dvec3 p, char up)
{
    return up == 'z' ? dvec3(p.x, p.z, -p.y) : p;
}

// How to move the scene to the middle, and to scale it into its box unless it keeps its metres.
Placement fit(const std::filesystem::path& path, const Obj& obj, char up, bool in_metres)
{
    dvec3 least(INFINITY), most(-INFINITY);
    for (const Polygon& polygon : obj.polygons) {
        for (const Corner& corner : polygon.corners) {
            least = glm::min(least, turn(obj.points[corner.point], up));
            most = glm::max(most, turn(obj.points[corner.point], up));
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
    double factor = 1;
    if (!in_metres) {
        factor = INFINITY;
        for (int axis = 0; axis < 3; ++axis) {
            if (size[axis] > 0) factor = std::min(factor, room[axis] / size[axis]);
        }
    }
    const dvec3 foot(0.5 * (least.x + most.x), least.y, 0.5 * (least.z + most.z));
    return {factor, foot};
}

// Where its points lie in the world. Computed in double precision, as coordinates may be large and
// differ little: those of maps count from the equator.
std::vector<vec3> place(const std::filesystem::path& path, const Obj& obj, char up,
                        const Placement& placement, bool in_metres)
{
    // m; beyond, voxels would be too large for what is drawn, and the camera would not see so far.
    const double most = in_metres ? 1000 : 100;
    std::vector<vec3> points;
    for (const dvec3& point : obj.points)
        points.emplace_back(placement.factor * (turn(point, up) - placement.foot));
    for (const Polygon& polygon : obj.polygons) {
        for (const Corner& corner : polygon.corners) {
            if (glm::length(points[corner.point]) <= most) continue;
            refuse_scene(path, in_metres
                                   ? "it reaches farther than 1000 m from its middle or from the "
                                     "scene that it belongs to (--metres scales nothing)"
                                   : "it reaches farther than 100 m from the scene that it "
                                     "belongs to (give both the same coordinates)");
        }
    }
    return points;
}

// Vertices that are the same in every bit are one.
struct Equal {
    bool operator()(const Vertex& a, const Vertex& b) const
    {
        return std::memcmp(&a, &b, sizeof(Vertex)) == 0;
    }
};
struct Hash {
    size_t operator()(const Vertex& vertex) const
    {
        return std::hash<std::string_view>()(
            {reinterpret_cast<const char*>(&vertex), sizeof(Vertex)});
    }
};

// Has it a picture, and a place in that for each of its corners?
bool is_pictured(const Polygon& polygon, const Materials& materials)
{
    return materials[polygon.material].has_picture() &&
           std::none_of(polygon.corners.begin(), polygon.corners.end(),
                        [](const Corner& corner) { return corner.uv == Corner::none; });
}

// Puts triangles of polygons together, whose materials come one after the other.
class Builder {
public:
    explicit Builder(const Obj& obj, const std::vector<vec3>& points) : obj_(obj), points_(points)
    {
        for (const Polygon& polygon : obj.polygons) add(polygon);
    }

    Scene scene;

private:
    void add(const Polygon& polygon)
    {
        const bool pictured = is_pictured(polygon, obj_.materials);
        if (scene.submeshes.empty() || polygon.material != material_ || pictured != pictured_) {
            material_ = polygon.material;
            pictured_ = pictured;
            scene.submeshes.push_back({obj_.materials[material_], scene.indices.size(), 0});
            Material& material = scene.submeshes.back().material;
            if (!pictured) material.picture = material.mask = "";
        }
        std::vector<dvec3> corners;
        for (const Corner& corner : polygon.corners) corners.push_back(points_[corner.point]);
        const std::vector<size_t> triangles = cut_into_triangles(corners);
        for (size_t i = 0; i < triangles.size(); i += 3) {
            const dvec3 a = corners[triangles[i]], b = corners[triangles[i + 1]],
                        c = corners[triangles[i + 2]];
            const vec3 flat = to_length_1(glm::cross(b - a, c - a), vec3(0, 1, 0));
            for (size_t k = i; k < i + 3; ++k) add(polygon.corners[triangles[k]], flat);
        }
        scene.submeshes.back().count = scene.indices.size() - scene.submeshes.back().first;
    }

    void add(const Corner& corner, vec3 flat)
    {
        Vertex vertex{};
        vertex.position = points_[corner.point];
        vertex.normal = flat;
        if (corner.normal != Corner::none)
            vertex.normal = to_length_1(obj_.normals[corner.normal], flat);
        const Material& material = scene.submeshes.back().material;
        vertex.colour = material_ == 0             ? obj_.colours[corner.point]
                        : material.picture.empty() ? material.colour
                                                   : material.tint;
        if (material.has_picture()) {
            const vec2 uv = material.uv_scale * obj_.uvs[corner.uv] + material.uv_offset;
            vertex.uv = glm::clamp(uv, -1e6f, 1e6f);  // beyond, a float has no fraction
        }
        const auto [place, is_new] = numbers_.emplace(vertex, uint32_t(scene.vertices.size()));
        if (is_new) scene.vertices.push_back(vertex);
        scene.indices.push_back(place->second);
    }

    // What has no length points as `otherwise`. Zero is added because -0 has other bits.
    static vec3 to_length_1(dvec3 direction, vec3 otherwise)
    {
        const double length = glm::length(direction);
        return length > 0 ? vec3(direction / length) + 0.0f : otherwise;
    }

    const Obj& obj_;
    const std::vector<vec3>& points_;
    size_t material_ = 0;  // of the last submesh
    bool pictured_ = false;
    std::unordered_map<Vertex, uint32_t, Hash, Equal> numbers_;
};

}  // namespace

Scene load_scene(const std::filesystem::path& path, char up, const Placement* other, bool in_metres)
{
    if (path == "none") return {};
    Obj obj = read_obj(path);
    if (obj.polygons.empty()) refuse_scene(path, "it has no faces (is it a Wavefront OBJ file?)");
    const Placement placement = other != nullptr ? *other : fit(path, obj, up, in_metres);
    const std::vector<vec3> points = place(path, obj, up, placement, in_metres);
    obj.materials.warnings.print();
    orient(obj.polygons, points);
    for (vec3& normal : obj.normals) normal = turn(normal, up);
    complete_normals(obj.polygons, obj.normals, points);
    const auto kind = [&](const Polygon& polygon) {
        return std::pair(polygon.material, is_pictured(polygon, obj.materials));
    };
    std::stable_sort(obj.polygons.begin(), obj.polygons.end(),
                     [&](const Polygon& a, const Polygon& b) { return kind(a) < kind(b); });

    Scene scene = Builder(obj, points).scene;
    scene.placement = placement;
    std::cout << "scene " << path.filename().string() << ": " << scene.indices.size() / 3
              << " triangles, scaled by " << placement.factor << "; their " << scene.indices.size()
              << " corners share " << scene.vertices.size() << " vertices" << std::endl;
    return scene;
}
