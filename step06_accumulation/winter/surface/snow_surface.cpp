#include "step06_accumulation/winter/surface/snow_surface.hpp"

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstring>
#include <map>
#include <utility>

#include "step05_collision/ground.hpp"
#include "step06_accumulation/winter/surface/grain.hpp"
#include "step06_accumulation/winter/surface/hollows.hpp"

namespace {

// Some order of vertices, to find those that are the same.
struct BytewiseLess {
    bool operator()(const SurfaceVertex& a, const SurfaceVertex& b) const
    {
        return std::memcmp(&a, &b, sizeof a) < 0;
    }
};

constexpr float least_upward = 0.1f;  // normal.y, as in scene.frag of step 6

using Point = std::array<float, 3>;

Point point_of(const Vertex& v)
{
    return {v.position.x, v.position.y, v.position.z};
}

// What is steep is lifted less. One point is lifted by as much in all triangles that meet there, or
// there would be gaps.
void lift_less_where_steep(std::vector<SurfacePart>& parts)
{
    const auto each = [&](const auto& change) {
        for (SurfacePart& part : parts) {
            for (SurfaceVertex& vertex : part.fine) change(vertex);
            for (SurfaceVertex& vertex : part.coarse) change(vertex);
        }
    };
    std::map<Point, float> lift;
    each([&](const SurfaceVertex& v) {
        if (v.skirt != 0) return;  // its normal points to the side
        float& most = lift[point_of(v.vertex)];
        // As in look.glsl.
        most = std::max(most, glm::smoothstep(least_upward, 0.4f, v.vertex.normal.y));
    });
    each([&](SurfaceVertex& v) { v.lift *= lift[point_of(v.vertex)]; });
}

}  // namespace

std::vector<SurfacePart> make_snow_surface(const Scene& scene, float fine_enough)
{
    const float longest = std::max(1.0f, fine_enough);  // m
    std::vector<SurfacePart> parts;
    const auto add = [&](const SurfaceVertex& a, const SurfaceVertex& b, const SurfaceVertex& c) {
        const auto longer = [&](const SurfaceVertex& p, const SurfaceVertex& q) {
            return glm::distance(p.vertex.position, q.vertex.position) > fine_enough;
        };
        const bool coarse = longer(a, b) || longer(b, c) || longer(c, a);
        std::vector<SurfaceVertex>& part = coarse ? parts.back().coarse : parts.back().fine;
        part.insert(part.end(), {a, b, c});
    };

    // The edges at which such a surface ends: one that two triangles share is met in both
    // directions.
    std::map<std::pair<Point, Point>, std::pair<Vertex, Vertex>> border;

    std::vector<std::array<Vertex, 3>> left;
    for (size_t i = 0; i < scene.indices.size(); i += 3) {
        if (parts.size() < scene.submeshes.size() && i == scene.submeshes[parts.size()].first)
            parts.emplace_back();
        left.push_back({scene.corner(i), scene.corner(i + 1), scene.corner(i + 2)});
        while (!left.empty()) {
            const std::array<Vertex, 3> triangle = left.back();
            left.pop_back();
            const glm::vec3 across = glm::cross(triangle[1].position - triangle[0].position,
                                                triangle[2].position - triangle[0].position);
            if (across.y <= least_upward * glm::length(across)) {
                const auto bare = [](const Vertex& vertex) {
                    return SurfaceVertex{vertex, 0, 0, {}};
                };
                std::vector<SurfaceVertex>& part = parts.back().bare;
                part.insert(part.end(), {bare(triangle[0]), bare(triangle[1]), bare(triangle[2])});
                continue;
            }
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
            add({a, 1, 0, {}}, {b, 1, 0, {}}, {c, 1, 0, {}});
            for (const auto& [from, to] : {std::pair(a, b), std::pair(b, c), std::pair(c, a)}) {
                if (border.erase({point_of(to), point_of(from)}) == 0)
                    border.insert({{point_of(from), point_of(to)}, {from, to}});
            }
        }
    }
    parts.emplace_back();
    for (const auto& [ends, vertices] : border) {
        auto [from, to] = vertices;
        // On the ground the snow goes on beyond the edge of a floor.
        constexpr float as_good_as_ground = 0.01f;  // m
        if (std::max(from.position.y, to.position.y) < as_good_as_ground) continue;
        const glm::vec3 along = to.position - from.position;
        from.normal = to.normal = glm::normalize(glm::cross(along, glm::vec3(0, 1, 0)));
        add({to, 1, 1, {}}, {from, 1, 1, {}}, {from, 0, 1, {}});
        add({to, 1, 1, {}}, {from, 0, 1, {}}, {to, 0, 1, {}});
    }
    lift_less_where_steep(parts);
    return parts;
}

SurfacePart make_field(const VoxelGrid& grid, bool with_middle)
{
    constexpr float farthest = 1500;  // m
    constexpr float margin = 1;       // m, of the ring in which snow becomes that of the field
    constexpr float wider = 2;        // each other one than the one inside it
    const int square = ground_square(grid), squares = (grid.resolution + square - 1) / square;
    const float half_size = 0.5f * grid.cell_size * float(grid.resolution);
    const glm::vec2 middle = glm::vec2(grid.origin.x, grid.origin.z) + half_size;
    const auto corner = [&](float size, int side, int i) {
        const float part = float(std::min(i * square, grid.resolution)) / float(grid.resolution);
        // Along two of the sides, which run the other way, so that corners match the ground's.
        glm::vec2 place(2 * (side < 2 ? part : 1 - part) - 1, 1);
        if (side % 2 == 1) place = {-place.y, place.x};
        if (side == 2) place = {place.x, -1};
        if (side == 3) place = {1, place.y};
        place = middle + size * place;
        const Vertex vertex{{place.x, ground_height, place.y}, {0, 1, 0}, ground_colour, {}};
        return SurfaceVertex{vertex, 1, 0, {0, 1, 0, 0}};
    };
    SurfacePart field;
    float inner = with_middle ? 0 : half_size;
    for (float outer = half_size + margin; inner < farthest; inner = outer, outer *= wider) {
        std::vector<SurfaceVertex>& ring = inner == half_size ? field.coarse : field.bare;
        for (int side = 0; side < 4; ++side) {
            for (int i = 0; i < squares; ++i) {
                const SurfaceVertex a = corner(inner, side, i), b = corner(inner, side, i + 1),
                                    c = corner(outer, side, i), d = corner(outer, side, i + 1);
                ring.insert(ring.end(), {a, c, d, a, d, b});
            }
        }
    }
    return field;
}

SnowSurface::SnowSurface(const SolidScene& solid)
    : vertices_(make_buffer()), indices_(make_buffer()), vao_(make_vertex_array()),
      on_bare_({{GL_VERTEX_SHADER, "step06_accumulation/winter/surface/bare.vert"},
                {GL_FRAGMENT_SHADER, "step06_accumulation/winter/surface/bare.frag"}}),
      on_dusted_({{GL_VERTEX_SHADER, "step06_accumulation/winter/surface/bare.vert"},
                  {GL_FRAGMENT_SHADER, "step06_accumulation/winter/surface/dusted.frag"}}),
      on_field_({{GL_VERTEX_SHADER, "step06_accumulation/winter/surface/field.vert"},
                 {GL_FRAGMENT_SHADER, "step06_accumulation/winter/surface/field.frag"}}),
      plain_(programs_with("surface.frag")), sparkling_(programs_with("sparkling.frag")),
      grain_(make_grain()), fine_enough_(3 * solid.grid.cell_size)
{
    std::vector<SurfaceVertex> vertices;
    std::vector<uint32_t> indices;
    std::map<SurfaceVertex, uint32_t, BytewiseLess> known;
    const auto add = [&](std::vector<Part>& parts, const std::vector<SurfaceVertex>& corners) {
        parts.push_back({parts.size(), indices.size(), GLsizei(corners.size())});
        for (const SurfaceVertex& corner : corners) {
            const auto [found, is_new] = known.insert({corner, uint32_t(vertices.size())});
            if (is_new) vertices.push_back(corner);
            indices.push_back(found->second);
        }
    };
    std::vector<SurfacePart> parts = make_snow_surface(solid.drawn, fine_enough_);
    find_hollows(parts);
    const SurfacePart field = make_field(solid.grid, solid.drawn.vertices.empty());
    std::vector<SurfaceVertex>& last = parts.back().coarse;  // without a picture, as the field
    last.insert(last.end(), field.coarse.begin(), field.coarse.end());
    for (const SurfacePart& part : parts) {
        add(bare_, part.bare);
        add(fine_, part.fine);
        add(coarse_, part.coarse);
    }
    add(field_, field.bare);
    glBindVertexArray(vao_);
    glBindBuffer(GL_ARRAY_BUFFER, vertices_);
    glBufferData(GL_ARRAY_BUFFER, GLsizeiptr(vertices.size() * sizeof(SurfaceVertex)),
                 vertices.data(), GL_STATIC_DRAW);
    glBindBuffer(GL_ELEMENT_ARRAY_BUFFER, indices_);
    glBufferData(GL_ELEMENT_ARRAY_BUFFER, GLsizeiptr(indices.size() * sizeof(uint32_t)),
                 indices.data(), GL_STATIC_DRAW);
    check_memory("the surface", double(vertices.size() * sizeof(SurfaceVertex)));
    const auto field_of = [](GLuint location, GLint floats, size_t offset) {
        glEnableVertexAttribArray(location);
        glVertexAttribPointer(location, floats, GL_FLOAT, GL_FALSE, sizeof(SurfaceVertex),
                              reinterpret_cast<const void*>(offset));
    };
    field_of(0, 3, offsetof(Vertex, position));
    field_of(1, 3, offsetof(Vertex, normal));
    field_of(2, 3, offsetof(Vertex, colour));
    field_of(3, 2, offsetof(Vertex, uv));
    field_of(4, 1, offsetof(SurfaceVertex, lift));
    field_of(5, 1, offsetof(SurfaceVertex, skirt));
    field_of(6, 4, offsetof(SurfaceVertex, even));
}

std::vector<snow::Parameter> SnowSurface::parameters()
{
    return {
        {"scene", "scene", "on/off", 0, 1, "the scene and the field around it, or only flakes",
         &scene},
        {"tessellation", "tessellation", "on/off", 0, 1,
         "the surface of the snow is as fine as it needs to be", &tessellation, 0, "", true},
        {"dusting", "dusting", "on/off", 0, 1, "snow clings to walls that the wind blows against",
         &dusting},
        {"sparkle", "sparkle", "on/off", 0, 1, "crystals on the snow flash in the sun", &sparkle},
    };
}

SnowSurface::Programs SnowSurface::programs_with(const std::string& fragment_shader)
{
    const std::string folder = "step06_accumulation/winter/surface/";
    return {Permutations({{GL_VERTEX_SHADER, folder + "surface.vert"},
                          {GL_FRAGMENT_SHADER, folder + fragment_shader}}),
            Permutations({{GL_VERTEX_SHADER, folder + "surface_patch.vert"},
                          {GL_TESS_CONTROL_SHADER, folder + "surface.tesc"},
                          {GL_TESS_EVALUATION_SHADER, folder + "surface.tese"},
                          {GL_FRAGMENT_SHADER, folder + fragment_shader}})};
}

void SnowSurface::draw(GLenum mode, const std::vector<Part>& parts, Program& program,
                       const ScenePictures* pictures)
{
    for (const Part& part : parts) {
        if (part.count == 0) continue;
        if (pictures != nullptr) pictures->set(program, part.submesh);
        glDrawElements(mode, part.count, GL_UNSIGNED_INT,
                       reinterpret_cast<const void*>(part.first * sizeof(uint32_t)));
    }
}

void SnowSurface::draw(const snow::Weather& weather, const ScenePictures& pictures,
                       const UseProgram& use_lit, const std::function<void(Program&)>& set_snow)
{
    glBindVertexArray(vao_);
    const auto set_grain = [this](Program& program) {
        program.set("grain_size", 1.28f);
        program.set_texture("grain", GRAIN_UNIT, GL_TEXTURE_2D, grain_);
    };
    const auto use_on_snow = [&](Permutations& all) -> Program& {
        Program& program = use_lit(all);
        set_snow(program);
        set_grain(program);
        return program;
    };
    const bool dusted = dusting && weather.wind != glm::vec3(0);
    Program& on_walls = use_lit(dusted ? on_dusted_ : on_bare_);
    if (dusted) set_grain(on_walls);
    draw(GL_TRIANGLES, bare_, on_walls, &pictures);
    Programs& programs = sparkle ? sparkling_ : plain_;
    Program& on_snow = use_on_snow(programs.as_is);
    draw(GL_TRIANGLES, fine_, on_snow, &pictures);
    if (tessellation) {
        Program& tessellated = use_on_snow(programs.tessellated);
        tessellated.set("fine_enough", fine_enough_);
        glPatchParameteri(GL_PATCH_VERTICES, 3);
        draw(GL_PATCHES, coarse_, tessellated, &pictures);
    } else {
        draw(GL_TRIANGLES, coarse_, on_snow, &pictures);
    }
    Program& on_field = use_lit(on_field_);
    on_field.set("ground_colour", ground_colour);
    draw(GL_TRIANGLES, field_, on_field);
}
