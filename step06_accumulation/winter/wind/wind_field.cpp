#include "step06_accumulation/winter/wind/wind_field.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <iostream>
#include <utility>

#include "common/harness/progress.hpp"

namespace {

using glm::ivec3;
using glm::vec3;

constexpr int n = AirFlow::cells;

size_t cell_index(ivec3 cell)
{
    return (size_t(cell.z) * n + size_t(cell.y)) * n + size_t(cell.x);
}

template <typename Function>
void for_each_cell(Function function)
{
    for (int z = 0; z < n; ++z) {
        for (int y = 0; y < n; ++y) {
            for (int x = 0; x < n; ++x) function(ivec3(x, y, z));
        }
    }
}

ivec3 unit(int axis)
{
    ivec3 direction(0);
    direction[axis] = 1;
    return direction;
}

// The voxels from `first` on along x, at most 32, a bit each.
uint32_t bits_along_x(const VoxelGrid& grid, ivec3 first, int count)
{
    const int words = grid.resolution / 32;
    if (first.y < 0 || first.z < 0) return 0;
    const uint32_t* row = &grid.words[size_t(first.z * grid.resolution + first.y) * size_t(words)];
    const int word = first.x >> 5;
    uint64_t bits = word >= 0 ? row[word] : 0;
    if (word + 1 < words) bits |= uint64_t(row[word + 1]) << 32;
    return uint32_t((bits >> (first.x & 31)) & ((uint64_t(1) << count) - 1));
}

// The part of the face below `cell` along `axis` through which one can pass from the middle of one
// cell to the middle of the other.
float open_part(const VoxelGrid& grid, ivec3 cell, int axis)
{
    if (axis == 1 && cell.y == 0) return 0;  // the ground
    const int size = grid.resolution / n;    // of a cell, in voxels
    const int reach = std::max(1, size / 2);
    const int across = axis == 1 ? 2 : 1;
    int blocked = 0;
    for (int row = 0; row < size; ++row) {
        ivec3 voxel = size * cell;
        if (axis == 0) {
            for (int column = 0; column < size; ++column) {
                const ivec3 way = voxel + ivec3(-reach, row, column);
                blocked += bits_along_x(grid, way, 2 * reach) != 0;
            }
        } else {
            uint32_t in_the_way = 0;
            voxel[across] += row;
            for (int depth = -reach; depth < reach; ++depth) {
                in_the_way |= bits_along_x(grid, voxel + depth * unit(axis), size);
            }
            blocked += std::popcount(in_the_way);
        }
    }
    return 1.0f - float(blocked) / float(size * size);
}

// Slows the air in the lee of everything, in wind along `axis`: from one layer of cells to the
// next, away from where it comes from, each passes on what finds a way through, mixed with the air
// beside it, as an eddy viscosity would (Counihan, Hunt and Jackson, "Wakes behind two-dimensional
// surface obstacles in turbulent boundary layers", 1974; here some 0.1 m2/s for each m/s of wind).
// Without this, air would close behind a wall just as it parts before it, and no place would be
// calm.
void add_wake(AirFlow& flow, int axis)
{
    const bool forwards = flow.speed[axis][0] > 0;
    const int across = (axis + 1) % 3, along = (axis + 2) % 3;
    std::vector<float> layer(size_t(n) * n, 1.0f), next(layer);  // part of the wind that is left
    const auto left = [&](ivec3 cell) {
        cell.y = std::max(cell.y, 0);  // on the ground as above it, outside of the cube the wind
        const int a = cell[across], b = cell[along];
        return a < 0 || b < 0 || a == n || b == n ? 1.0f : layer[size_t(n * b + a)];
    };
    for (int i = 0; i <= n; ++i) {
        ivec3 cell;
        cell[axis] = forwards ? i : n - i;
        for (int b = 0; b < n; ++b) {
            for (int a = 0; a < n; ++a) {
                cell[across] = a;
                cell[along] = b;
                const ivec3 side = unit(across), top = unit(along);
                const float mean = 0.2f * (left(cell) + left(cell - side) + left(cell + side) +
                                           left(cell - top) + left(cell + top));
                const size_t face = AirFlow::face(cell.x, cell.y, cell.z);
                flow.speed[axis][face] *= mean;
                // The scene may have stood as far into the face before: only what is new stops air.
                const ivec3 before = cell + (forwards ? -1 : 1) * unit(axis);
                const float open = flow.open[axis][face];
                const float was =
                    i == 0 ? 1.0f : flow.open[axis][AirFlow::face(before.x, before.y, before.z)];
                next[size_t(n * b + a)] = open < was ? mean * open / was : open > 0 ? mean : 0;
            }
        }
        std::swap(layer, next);
    }
}

// What flows out of a cell less what flows in.
float divergence(const AirFlow& flow, ivec3 cell)
{
    float sum = 0;
    for (int axis = 0; axis < 3; ++axis) {
        const ivec3 next = cell + unit(axis);
        const size_t low = AirFlow::face(cell.x, cell.y, cell.z);
        const size_t high = AirFlow::face(next.x, next.y, next.z);
        sum += flow.open[axis][high] * flow.speed[axis][high] -
               flow.open[axis][low] * flow.speed[axis][low];
    }
    return sum;
}

// Subtracts the gradient of the pressure, which is 0 outside the cube.
void subtract_gradient(AirFlow& flow, const std::vector<float>& pressure)
{
    const auto at = [&](ivec3 cell) {
        const bool inside = glm::all(glm::greaterThanEqual(cell, ivec3(0))) &&
                            glm::all(glm::lessThan(cell, ivec3(n)));
        return inside ? pressure[cell_index(cell)] : 0.0f;
    };
    for (int axis = 0; axis < 3; ++axis) {
        for (int z = 0; z <= n; ++z) {
            for (int y = 0; y <= n; ++y) {
                for (int x = 0; x <= n; ++x) {
                    const ivec3 cell(x, y, z);
                    flow.speed[axis][AirFlow::face(x, y, z)] -= at(cell) - at(cell - unit(axis));
                }
            }
        }
    }
}

}  // namespace

vec3 AirFlow::at_cell(ivec3 cell) const
{
    vec3 mean;
    for (int axis = 0; axis < 3; ++axis) {
        const ivec3 next = cell + unit(axis);
        const size_t low = face(cell.x, cell.y, cell.z), high = face(next.x, next.y, next.z);
        mean[axis] =
            0.5f * (open[axis][low] * speed[axis][low] + open[axis][high] * speed[axis][high]);
    }
    return mean;
}

AirFlow flow_around(const VoxelGrid& grid, vec3 wind)
{
    AirFlow flow{};
    for (int axis = 0; axis < 3; ++axis) {
        flow.speed[axis].assign(size_t(n + 1) * (n + 1) * (n + 1), wind[axis]);
        flow.open[axis].assign(flow.speed[axis].size(), 1.0f);
        for_each_cell([&](ivec3 cell) {
            flow.open[axis][AirFlow::face(cell.x, cell.y, cell.z)] = open_part(grid, cell, axis);
        });
        if (wind[axis] != 0) add_wake(flow, axis);
    }

    // Conjugate gradients for the pressure p: minus the divergence of open * grad p is minus that
    // of open * wind.
    const size_t count = size_t(n) * n * n;
    std::vector<float> pressure(count, 0), rest(count), direction(count), image(count);
    for_each_cell([&](ivec3 cell) { rest[cell_index(cell)] = -divergence(flow, cell); });
    const auto apply = [&](const std::vector<float>& p, std::vector<float>& result) {
        for_each_cell([&](ivec3 cell) {
            const size_t here = cell_index(cell);
            float sum = 0;
            for (int axis = 0; axis < 3; ++axis) {
                const ivec3 step = unit(axis), next = cell + step;
                const float low = cell[axis] > 0 ? p[cell_index(cell - step)] : 0.0f;
                const float high = next[axis] < n ? p[cell_index(next)] : 0.0f;
                sum += flow.open[axis][AirFlow::face(cell.x, cell.y, cell.z)] * (p[here] - low) +
                       flow.open[axis][AirFlow::face(next.x, next.y, next.z)] * (p[here] - high);
            }
            result[here] = sum;
        });
    };
    const auto dot = [](const std::vector<float>& a, const std::vector<float>& b) {
        double sum = 0;
        for (size_t i = 0; i < a.size(); ++i) sum += double(a[i]) * double(b[i]);
        return sum;
    };
    direction = rest;
    double squared = dot(rest, rest);
    for (int iteration = 0; iteration < 500 && squared > 1e-7; ++iteration) {
        apply(direction, image);
        const float length = float(squared / dot(direction, image));
        for (size_t i = 0; i < count; ++i) {
            pressure[i] += length * direction[i];
            rest[i] -= length * image[i];
        }
        const double before = std::exchange(squared, dot(rest, rest));
        for (size_t i = 0; i < count; ++i)
            direction[i] = rest[i] + float(squared / before) * direction[i];
    }
    subtract_gradient(flow, pressure);
    for_each_cell([&](ivec3 cell) {
        flow.residual = std::max(flow.residual, std::abs(divergence(flow, cell)));
    });
    return flow;
}

WindField::WindField(const VoxelGrid& grid)
{
    Progress progress("wind");
    float residual = 0;
    const vec3 winds[] = {vec3(1, 0, 0), vec3(-1, 0, 0), vec3(0, 0, 1), vec3(0, 0, -1)};
    for (int i = 0; i < 4; ++i) {
        const AirFlow flow = flow_around(grid, winds[i]);
        residual = std::max(residual, flow.residual);
        const float sign = winds[i].x + winds[i].z;  // the shader multiplies with the wind's own
        std::vector<vec3> texels(size_t(n) * n * n);
        for_each_cell([&](ivec3 cell) { texels[cell_index(cell)] = sign * flow.at_cell(cell); });
        flows_[i] = make_texture();
        glBindTexture(GL_TEXTURE_3D, flows_[i]);
        glTexImage3D(GL_TEXTURE_3D, 0, GL_RGB32F, n, n, n, 0, GL_RGB, GL_FLOAT, texels.data());
        glTexParameteri(GL_TEXTURE_3D, GL_TEXTURE_MIN_FILTER, GL_LINEAR);
        for (const GLenum wrap : {GL_TEXTURE_WRAP_S, GL_TEXTURE_WRAP_T, GL_TEXTURE_WRAP_R}) {
            glTexParameteri(GL_TEXTURE_3D, wrap, GL_CLAMP_TO_EDGE);
        }
        if (progress.due()) progress.report((i + 1) / 4.0);
    }
    std::cout << "wind: " << n << "^3 cells, largest divergence " << residual
              << " of the speed a cell" << std::endl;
}

std::vector<snow::Parameter> WindField::parameters()
{
    return {
        {"wind_field", "around the scene", "on/off", 0, 1, "the wind flows around the scene",
         &wind_field},
        {"arrows", "arrows", "on/off", 0, 1, "the wind as arrows, the redder the faster", &arrows,
         'W'},
        {"gusts", "gusts", "", 0, 2, "largest change of the wind in a gust, relative", &gusts},
    };
}

Program& WindField::use(Permutations& all, const snow::Weather& weather) const
{
    const bool flows = wind_field && (weather.wind.x != 0 || weather.wind.z != 0);
    Program& program = all.with(flows ? "#define AROUND_THE_SCENE\n" : "");
    program.use();
    program.set("gusts", gusts);
    program.set_texture("wind_along_x", WIND_X_UNIT, GL_TEXTURE_3D,
                        flows_[weather.wind.x < 0 ? 1 : 0]);
    program.set_texture("wind_along_z", WIND_Z_UNIT, GL_TEXTURE_3D,
                        flows_[weather.wind.z < 0 ? 3 : 2]);
    return program;
}
