#include "step06_accumulation/winter/surface/snow_surface.hpp"

#include <array>
#include <cstddef>
#include <map>
#include <utility>

std::vector<SurfacePart> make_snow_surface(const Scene& scene, float fine_enough)
{
    constexpr float longest = 1;          // m
    constexpr float least_upward = 0.1f;  // normal.y of a surface that snow can lie on
    std::vector<SurfacePart> parts;
    const auto add = [&](const SurfaceVertex& a, const SurfaceVertex& b, const SurfaceVertex& c) {
        const auto longer = [&](const SurfaceVertex& p, const SurfaceVertex& q) {
            return glm::distance(p.vertex.position, q.vertex.position) > fine_enough;
        };
        const bool coarse =
            a.lift + b.lift + c.lift > 0 && (longer(a, b) || longer(b, c) || longer(c, a));
        std::vector<SurfaceVertex>& part = coarse ? parts.back().coarse : parts.back().fine;
        part.insert(part.end(), {a, b, c});
    };

    // The edges at which such a surface ends: one that two triangles share is met in both
    // directions.
    using Point = std::array<float, 3>;
    const auto point = [](const Vertex& v) {
        return Point{v.position.x, v.position.y, v.position.z};
    };
    std::map<std::pair<Point, Point>, std::pair<Vertex, Vertex>> border;

    std::vector<std::array<Vertex, 3>> left;
    for (size_t i = 0; i < scene.indices.size(); i += 3) {
        if (parts.size() < scene.submeshes.size() && i == scene.submeshes[parts.size()].first)
            parts.emplace_back();
        left.push_back({scene.corner(i), scene.corner(i + 1), scene.corner(i + 2)});
        while (!left.empty()) {
            const std::array<Vertex, 3> triangle = left.back();
            left.pop_back();
            // Turned so that the longest edge comes first.
            size_t split = 0;
            const auto length = [&](size_t edge) {
                return glm::distance(triangle[edge].position, triangle[(edge + 1) % 3].position);
            };
            for (const size_t edge : {1, 2}) {
                if (length(edge) > length(split)) split = edge;
            }
            const Vertex a = triangle[split], b = triangle[(split + 1) % 3],
                         c = triangle[(split + 2) % 3];
            if (length(split) > longest) {
                const Vertex middle{0.5f * (a.position + b.position), 0.5f * (a.normal + b.normal),
                                    0.5f * (a.colour + b.colour), 0.5f * (a.uv + b.uv)};
                left.push_back({a, middle, c});
                left.push_back({middle, b, c});
                continue;
            }
            const glm::vec3 across = glm::cross(b.position - a.position, c.position - a.position);
            const float lift = across.y > least_upward * glm::length(across) ? 1.0f : 0.0f;
            add({a, lift, 0}, {b, lift, 0}, {c, lift, 0});
            if (lift == 0) continue;
            for (const auto& [from, to] : {std::pair(a, b), std::pair(b, c), std::pair(c, a)}) {
                if (border.erase({point(to), point(from)}) == 0)
                    border.insert({{point(from), point(to)}, {from, to}});
            }
        }
    }
    parts.emplace_back();
    for (const auto& [ends, vertices] : border) {
        auto [from, to] = vertices;
        const glm::vec3 along = to.position - from.position;
        from.normal = to.normal = glm::normalize(glm::cross(along, glm::vec3(0, 1, 0)));
        add({to, 1, 1}, {from, 1, 1}, {from, 0, 1});
        add({to, 1, 1}, {from, 0, 1}, {to, 0, 1});
    }
    return parts;
}

SnowSurface::SnowSurface(const Scene& scene, float cell_size)
    : buffer_(make_buffer()), vao_(make_vertex_array()),
      untessellated_({{GL_VERTEX_SHADER, "step06_accumulation/winter/surface/surface.vert"},
                      {GL_FRAGMENT_SHADER, "step06_accumulation/winter/surface/surface.frag"}}),
      tessellated_({{GL_VERTEX_SHADER, "step06_accumulation/winter/surface/surface_patch.vert"},
                    {GL_TESS_CONTROL_SHADER, "step06_accumulation/winter/surface/surface.tesc"},
                    {GL_TESS_EVALUATION_SHADER, "step06_accumulation/winter/surface/surface.tese"},
                    {GL_FRAGMENT_SHADER, "step06_accumulation/winter/surface/surface.frag"}}),
      fine_enough_(3 * cell_size)
{
    std::vector<SurfaceVertex> vertices;
    const auto add = [&](std::vector<Part>& parts, const std::vector<SurfaceVertex>& part) {
        const size_t submesh = parts.size();
        parts.push_back({submesh, GLint(vertices.size()), GLsizei(part.size())});
        vertices.insert(vertices.end(), part.begin(), part.end());
    };
    for (const SurfacePart& part : make_snow_surface(scene, fine_enough_)) {
        add(coarse_, part.coarse);
        add(fine_, part.fine);
    }
    glBindVertexArray(vao_);
    glBindBuffer(GL_ARRAY_BUFFER, buffer_);
    glBufferData(GL_ARRAY_BUFFER, GLsizeiptr(vertices.size() * sizeof(SurfaceVertex)),
                 vertices.data(), GL_STATIC_DRAW);
    const auto field = [](GLuint location, GLint floats, size_t offset) {
        glEnableVertexAttribArray(location);
        glVertexAttribPointer(location, floats, GL_FLOAT, GL_FALSE, sizeof(SurfaceVertex),
                              reinterpret_cast<const void*>(offset));
    };
    field(0, 3, offsetof(Vertex, position));
    field(1, 3, offsetof(Vertex, normal));
    field(2, 3, offsetof(Vertex, colour));
    field(3, 2, offsetof(Vertex, uv));
    field(4, 1, offsetof(SurfaceVertex, lift));
    field(5, 1, offsetof(SurfaceVertex, skirt));
}

std::vector<snow::Parameter> SnowSurface::parameters()
{
    return {
        {"tessellation", "tessellation", "on/off", 0, 1,
         "the surface of the snow is as fine as it needs to be", &tessellation},
        {"sparkle", "sparkle", "on/off", 0, 1, "crystals on the snow flash in the sun", &sparkle},
    };
}

std::vector<Program*> SnowSurface::programs()
{
    return {&untessellated_, &tessellated_};
}

void SnowSurface::draw(GLenum mode, const std::vector<Part>& parts, Program& program,
                       const ScenePictures& pictures)
{
    for (const Part& part : parts) {
        if (part.count == 0) continue;
        pictures.set(program, part.submesh);
        glDrawArrays(mode, part.first, part.count);
    }
}

void SnowSurface::draw(const ScenePictures& pictures)
{
    glBindVertexArray(vao_);
    untessellated_.use();
    untessellated_.set("sparkle", sparkle != 0 ? 1 : 0);
    draw(GL_TRIANGLES, fine_, untessellated_, pictures);
    if (tessellation == 0) return draw(GL_TRIANGLES, coarse_, untessellated_, pictures);
    tessellated_.use();
    tessellated_.set("sparkle", sparkle != 0 ? 1 : 0);
    tessellated_.set("fine_enough", fine_enough_);
    glPatchParameteri(GL_PATCH_VERTICES, 3);
    draw(GL_PATCHES, coarse_, tessellated_, pictures);
}
