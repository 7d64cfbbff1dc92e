#include "step06_accumulation/winter/surface/hollows.hpp"

#include <array>
#include <cmath>
#include <map>
#include <optional>
#include <utility>

namespace {

using glm::vec2;
using glm::vec3;

constexpr float around = 0.35f;  // m, that is to be even; and up and down from there

// The surfaces that snow can lie on, by the square of the ground that they are over.
class Surfaces {
public:
    void add(vec3 a, vec3 b, vec3 c)
    {
        const glm::ivec2 first = square(glm::min(a, glm::min(b, c))),
                         last = square(glm::max(a, glm::max(b, c)));
        for (int x = first.x; x <= last.x; ++x) {
            for (int z = first.y; z <= last.y; ++z) squares_[{x, z}].push_back({a, b, c});
        }
    }

    // The height of the surface over or under a point which is nearest to it, unless it is too far.
    std::optional<float> height(vec3 point) const
    {
        const glm::ivec2 over = square(point);
        const auto found = squares_.find({over.x, over.y});
        if (found == squares_.end()) return {};
        std::optional<float> best;
        for (const auto& [a, b, c] : found->second) {
            const vec2 u(b.x - a.x, b.z - a.z), v(c.x - a.x, c.z - a.z),
                p(point.x - a.x, point.z - a.z);
            const float area = u.x * v.y - u.y * v.x;
            const float s = (p.x * v.y - p.y * v.x) / area, t = (u.x * p.y - u.y * p.x) / area;
            if (!(s >= 0 && t >= 0 && s + t <= 1)) continue;
            const float y = a.y + s * (b.y - a.y) + t * (c.y - a.y);
            if (std::abs(y - point.y) < (best ? std::abs(*best - point.y) : around)) best = y;
        }
        return best;
    }

private:
    static glm::ivec2 square(vec3 point)
    {
        constexpr float size = 0.5f;  // m
        return {int(std::floor(point.x / size)), int(std::floor(point.z / size))};
    }

    std::map<std::pair<int, int>, std::vector<std::array<vec3, 3>>> squares_;
};

// The plane that fits best the surface around a point: its normal, and how far above the point it
// passes.
glm::vec4 even_surface(const Surfaces& surfaces, vec3 middle, vec3 normal)
{
    constexpr int directions = 8;
    float count = 0;
    vec3 sum(0);  // of x, y, z, from the middle
    float xx = 0, xz = 0, zz = 0, xy = 0, zy = 0;
    for (const float distance : {0.0f, 0.5f * around, around}) {
        for (int i = 0; i < (distance > 0 ? directions : 1); ++i) {
            const float turn = 6.2831853f * float(i) / directions;
            const vec3 point = middle + distance * vec3(std::cos(turn), 0, std::sin(turn));
            const std::optional<float> height = surfaces.height(point);
            if (!height) continue;
            const vec3 p(point.x - middle.x, *height - middle.y, point.z - middle.z);
            ++count;
            sum += p;
            xx += p.x * p.x, xz += p.x * p.z, zz += p.z * p.z, xy += p.x * p.y, zy += p.z * p.y;
        }
    }
    const float all = 1 + 2 * directions;
    if (count < 0.6f * all) return {normal, 0};  // close to an edge
    const vec3 mean = sum / count;
    xx -= sum.x * mean.x, xz -= sum.x * mean.z, zz -= sum.z * mean.z;
    xy -= sum.x * mean.y, zy -= sum.z * mean.y;
    const float determinant = xx * zz - xz * xz;
    if (determinant <= 1e-6f) return {normal, 0};
    const float along_x = (xy * zz - zy * xz) / determinant,
                along_z = (zy * xx - xy * xz) / determinant;
    return {glm::normalize(vec3(-along_x, 1, -along_z)),
            mean.y - along_x * mean.x - along_z * mean.z};
}

}  // namespace

void find_hollows(std::vector<SurfaceSubmesh>& submeshes)
{
    Surfaces surfaces;
    for (const SurfaceSubmesh& submesh : submeshes) {
        for (const auto* corners : {&submesh.fine, &submesh.coarse}) {
            for (size_t i = 0; i < corners->size(); i += 3) {
                if ((*corners)[i].skirt > 0) continue;
                surfaces.add((*corners)[i].vertex.position, (*corners)[i + 1].vertex.position,
                             (*corners)[i + 2].vertex.position);
            }
        }
    }
    std::map<std::array<float, 3>, glm::vec4> known;
    for (SurfaceSubmesh& submesh : submeshes) {
        for (auto* corners : {&submesh.fine, &submesh.coarse}) {
            for (SurfaceVertex& corner : *corners) {
                if (corner.displacement == 0) continue;
                const vec3 p = corner.vertex.position;
                const auto [found, is_new] = known.insert({{p.x, p.y, p.z}, glm::vec4(0)});
                if (is_new) found->second = even_surface(surfaces, p, corner.vertex.normal);
                corner.even = found->second;
            }
        }
    }
}
