#include "step06_accumulation/winter/surface/snow_surface.hpp"

#include <algorithm>
#include <array>
#include <bit>
#include <iterator>
#include <map>
#include <utility>

#include "step05_collision/ground.hpp"

namespace {

constexpr float least_upward = 0.1f;  // normal.y, as in whitened.glsl of step 6

using Point = std::array<float, 3>;

Point point_of(glm::vec3 position)
{
    return {position.x, position.y, position.z};
}

// Steep surfaces are displaced less, a point alike in all triangles that meet there, or there would
// be gaps. And deep snow faces the way that all within a box around it does.
void fit_snow(std::vector<SurfaceSubmesh>& submeshes)
{
    const auto each = [&](const auto& change) {
        for (SurfaceSubmesh& submesh : submeshes) {
            for (SurfaceVertex& vertex : submesh.fine) change(vertex);
            for (SurfaceVertex& vertex : submesh.coarse) change(vertex);
        }
    };
    const auto box_of = [](const SurfaceVertex& v) {
        return point_of(glm::floor(v.vertex.position / 0.5f));  // 0.5: m
    };
    std::map<Point, float> displacement;
    std::map<Point, glm::vec3> facing;
    each([&](const SurfaceVertex& v) {
        if (v.skirt != 0) return;  // its normal points to the side
        float& most = displacement[point_of(v.vertex.position)];
        // As in surface.frag.
        most = std::max(most, glm::smoothstep(least_upward, 0.4f, v.vertex.normal.y));
        facing[box_of(v)] += v.vertex.normal;
    });
    each([&](SurfaceVertex& v) {
        v.displacement *= displacement[point_of(v.vertex.position)];
        v.even_normal = v.skirt != 0 ? v.vertex.normal : glm::normalize(facing[box_of(v)]);
    });
}

float length(const Vertex& from, const Vertex& to)
{
    return glm::distance(from.position, to.position);
}

}  // namespace

std::vector<SurfaceSubmesh> make_snow_surface(const Scene& scene, float fine_enough)
{
    const float longest = std::max(1.0f, fine_enough);  // m
    std::vector<SurfaceSubmesh> submeshes;
    const auto add = [&](const SurfaceVertex& a, const SurfaceVertex& b, const SurfaceVertex& c) {
        const bool coarse = std::max({length(a.vertex, b.vertex), length(b.vertex, c.vertex),
                                      length(c.vertex, a.vertex)}) > fine_enough;
        std::vector<SurfaceVertex>& corners =
            coarse ? submeshes.back().coarse : submeshes.back().fine;
        corners.insert(corners.end(), {a, b, c});
    };

    // The edges at which such a surface ends: one that two triangles share is met in both
    // directions.
    std::map<std::pair<Point, Point>, std::pair<Vertex, Vertex>> border;

    std::vector<std::array<Vertex, 3>> left;
    for (size_t i = 0; i < scene.indices.size(); i += 3) {
        if (submeshes.size() < scene.submeshes.size() &&
            i == scene.submeshes[submeshes.size()].first)
            submeshes.emplace_back();
        left.push_back({scene.corner(i), scene.corner(i + 1), scene.corner(i + 2)});
        while (!left.empty()) {
            std::array<Vertex, 3> triangle = left.back();
            left.pop_back();
            auto& [a, b, c] = triangle;
            const glm::vec3 across = glm::cross(b.position - a.position, c.position - a.position);
            if (across.y <= least_upward * glm::length(across)) {
                for (const Vertex& vertex : triangle)
                    submeshes.back().bare.push_back({vertex, 0, 0});
                continue;
            }
            // Turned so that the longest edge comes first.
            while (length(a, b) < std::max(length(b, c), length(c, a)))
                std::rotate(triangle.begin(), triangle.begin() + 1, triangle.end());
            if (length(a, b) > longest) {
                const Vertex middle{0.5f * (a.position + b.position), 0.5f * (a.normal + b.normal),
                                    0.5f * (a.colour + b.colour), 0.5f * (a.uv + b.uv)};
                left.push_back({a, middle, c});
                left.push_back({middle, b, c});
                continue;
            }
            add({a, 1, 0}, {b, 1, 0}, {c, 1, 0});
            for (const auto& [from, to] : {std::pair(a, b), std::pair(b, c), std::pair(c, a)}) {
                if (border.erase({point_of(to.position), point_of(from.position)}) == 0)
                    border.insert({{point_of(from.position), point_of(to.position)}, {from, to}});
            }
        }
    }
    submeshes.emplace_back();
    for (const auto& [ends, vertices] : border) {
        auto [from, to] = vertices;
        // On the ground the snow goes on beyond the edge of a floor.
        constexpr float as_good_as_ground = 0.01f;  // m
        if (std::max(from.position.y, to.position.y) < as_good_as_ground) continue;
        const glm::vec3 along = to.position - from.position;
        from.normal = to.normal = glm::normalize(glm::cross(along, glm::vec3(0, 1, 0)));
        add({to, 1, 1}, {from, 1, 1}, {from, 0, 1});
        add({to, 1, 1}, {from, 0, 1}, {to, 0, 1});
    }
    fit_snow(submeshes);
    return submeshes;
}

SurfaceSubmesh make_field(const VoxelGrid& grid, bool with_middle)
{
    constexpr float farthest = 1500;  // m
    constexpr float margin = 1;       // m, of the ring that joins the field to the scene
    constexpr float wider = 2;        // each other one than the one inside it
    const float half_size = 0.5f * grid.cell_size * float(grid.resolution);
    std::vector<float> knots{-half_size, half_size};  // m from the middle, along x and z
    for (int voxel = ground_square(grid); voxel < grid.resolution; voxel += ground_square(grid))
        knots.push_back(float(voxel) * grid.cell_size - half_size);
    for (float outer = half_size + margin; outer < wider * farthest; outer *= wider)
        knots.insert(knots.end(), {-outer, outer});
    std::sort(knots.begin(), knots.end());
    const auto corner = [&](size_t x, size_t z) {
        const glm::vec3 at(knots[x] + half_size, 0, knots[z] + half_size);
        const Vertex vertex{{grid.origin.x + at.x, ground_height, grid.origin.z + at.z},
                            {0, 1, 0},
                            ground_colour,
                            {}};
        return SurfaceVertex{vertex, 1, 0};
    };
    SurfaceSubmesh field;
    for (size_t x = 0; x + 1 < knots.size(); ++x) {
        for (size_t z = 0; z + 1 < knots.size(); ++z) {
            const float away = std::max({-knots[x], knots[x + 1], -knots[z], knots[z + 1]});
            if (away <= half_size && !with_middle) continue;
            const bool joins = away <= half_size + margin && !with_middle;
            const SurfaceVertex a = corner(x, z), b = corner(x, z + 1), c = corner(x + 1, z),
                                d = corner(x + 1, z + 1);
            std::vector<SurfaceVertex>& ring = joins ? field.coarse : field.bare;
            ring.insert(ring.end(), {a, b, d, a, d, c});
        }
    }
    return field;
}

SnowSurface::SnowSurface(const SolidScene& solid)
    : solid_(solid), vertices_(make_buffer()), indices_(make_buffer()), vao_(make_vertex_array()),
      on_bare_({{GL_VERTEX_SHADER, "step06_accumulation/winter/surface/bare.vert"},
                {GL_FRAGMENT_SHADER, "step06_accumulation/winter/surface/bare.frag"}},
               SHADOW | OCCLUSION | LAMP | DUSTING | WET),
      on_field_({{GL_VERTEX_SHADER, "step06_accumulation/winter/surface/bare.vert"},
                 {GL_FRAGMENT_SHADER, "step06_accumulation/winter/surface/field.frag"}},
                SHADOW | LAMP | WET),
      on_snow_({{GL_VERTEX_SHADER, "step06_accumulation/winter/surface/surface.vert"},
                {GL_FRAGMENT_SHADER, "step06_accumulation/winter/surface/surface.frag"}},
               SHADOW | OCCLUSION | LAMP | SPARKLE | WET),
      on_snow_tessellated_(
          {{GL_VERTEX_SHADER, "step06_accumulation/winter/surface/surface.vert"},
           {GL_TESS_CONTROL_SHADER, "step06_accumulation/winter/surface/surface.tesc"},
           {GL_TESS_EVALUATION_SHADER, "step06_accumulation/winter/surface/surface.tese"},
           {GL_FRAGMENT_SHADER, "step06_accumulation/winter/surface/surface.frag"}},
          SHADOW | OCCLUSION | LAMP | SPARKLE | WET | TESSELLATED)
{
    std::vector<SurfaceVertex> vertices;
    std::vector<uint32_t> indices;
    std::map<std::array<uint32_t, sizeof(SurfaceVertex) / 4>, uint32_t> known;  // by their bits
    const auto add = [&](std::vector<Range>& ranges, const std::vector<SurfaceVertex>& corners) {
        ranges.push_back({ranges.size(), indices.size(), GLsizei(corners.size())});
        for (const SurfaceVertex& corner : corners) {
            const auto [found, is_new] = known.insert(
                {std::bit_cast<decltype(known)::key_type>(corner), uint32_t(vertices.size())});
            if (is_new) vertices.push_back(corner);
            indices.push_back(found->second);
        }
    };
    std::vector<SurfaceSubmesh> submeshes =
        make_snow_surface(solid.drawn, 3 * solid.grid.cell_size);
    const SurfaceSubmesh field = make_field(solid.grid, solid.drawn.vertices.empty());
    // The last has no picture, as the field.
    std::vector<SurfaceVertex>& last = submeshes.back().coarse;
    last.insert(last.end(), field.coarse.begin(), field.coarse.end());
    for (const SurfaceSubmesh& submesh : submeshes) {
        add(bare_, submesh.bare);
        add(fine_, submesh.fine);
        add(coarse_, submesh.coarse);
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
    const GLint floats[] = {3, 3, 3, 2, 1, 1, 3};  // of the fields of SurfaceVertex, in their order
    size_t offset = 0;
    for (GLuint i = 0; i < std::size(floats); offset += sizeof(float) * size_t(floats[i++])) {
        glEnableVertexAttribArray(i);
        glVertexAttribPointer(i, floats[i], GL_FLOAT, GL_FALSE, sizeof(SurfaceVertex),
                              reinterpret_cast<const void*>(offset));
    }
}

void SnowSurface::draw(unsigned features, bool tessellated)
{
    glBindVertexArray(vao_);
    draw(GL_TRIANGLES, bare_, on_bare_.use(features));
    draw(GL_TRIANGLES, fine_, on_snow_.use(features));
    if (tessellated) {
        glPatchParameteri(GL_PATCH_VERTICES, 3);
        draw(GL_PATCHES, coarse_, on_snow_tessellated_.use(features | TESSELLATED));
    } else {
        draw(GL_TRIANGLES, coarse_, on_snow_.use(features));
    }
    draw(GL_TRIANGLES, field_, on_field_.use(features));
}

void SnowSurface::draw(GLenum mode, const std::vector<Range>& ranges, Program& program) const
{
    constexpr float brightness = 12;  // of the glass of a lamp
    const std::vector<Submesh>& submeshes = solid_.drawn.submeshes;
    for (const Range& range : ranges) {
        if (range.count == 0) continue;
        solid_.pictures.set(program, range.submesh);
        const bool is_of_scene = range.submesh < submeshes.size();  // not of the snow's sides
        if (&ranges != &field_) {
            program.set("own_light", is_of_scene
                                         ? brightness * submeshes[range.submesh].material.light
                                         : glm::vec3(0));
        }
        glDrawElements(mode, range.count, GL_UNSIGNED_INT,
                       reinterpret_cast<const void*>(range.first * sizeof(uint32_t)));
    }
}
