#include "step06_accumulation/wind_field.hpp"

#include <algorithm>
#include <cmath>
#include <iostream>
#include <utility>

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

// The part of the face below `cell` along `axis` through which one can pass from the middle of one
// cell to the middle of the other.
float open_part(const VoxelGrid& grid, ivec3 cell, int axis)
{
    if (axis == 1 && cell.y == 0) return 0;  // the ground
    const int size = grid.resolution / n;    // of a cell, in voxels
    const int reach = std::max(1, size / 2);
    const int across = (axis + 1) % 3, along = (axis + 2) % 3;
    int free = 0;
    for (int a = 0; a < size; ++a) {
        for (int b = 0; b < size; ++b) {
            ivec3 voxel = size * cell;
            voxel[across] += a;
            voxel[along] += b;
            bool blocked = false;
            for (int depth = -reach; depth < reach && !blocked; ++depth) {
                blocked = grid.solid(voxel + depth * unit(axis));
            }
            free += blocked ? 0 : 1;
        }
    }
    return float(free) / float(size * size);
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
    float residual = 0;
    const auto upload = [&](vec3 wind) {
        const AirFlow flow = flow_around(grid, wind);
        residual = std::max(residual, flow.residual);
        std::vector<vec3> texels(size_t(n) * n * n);
        for_each_cell([&](ivec3 cell) { texels[cell_index(cell)] = flow.at_cell(cell); });
        GlObject texture = make_texture();
        glBindTexture(GL_TEXTURE_3D, texture);
        glTexImage3D(GL_TEXTURE_3D, 0, GL_RGB32F, n, n, n, 0, GL_RGB, GL_FLOAT, texels.data());
        glTexParameteri(GL_TEXTURE_3D, GL_TEXTURE_MIN_FILTER, GL_LINEAR);
        for (const GLenum wrap : {GL_TEXTURE_WRAP_S, GL_TEXTURE_WRAP_T, GL_TEXTURE_WRAP_R}) {
            glTexParameteri(GL_TEXTURE_3D, wrap, GL_CLAMP_TO_EDGE);
        }
        return texture;
    };
    along_x_ = upload(vec3(1, 0, 0));
    along_z_ = upload(vec3(0, 0, 1));
    std::cout << "wind: " << n << "^3 cells, largest divergence " << residual
              << " of the speed a cell" << std::endl;
}

void WindField::set(Program& program, const Options& options) const
{
    program.set("around_the_scene", options.on("wind_field") ? 1 : 0);
    program.set("gusts", options.setting("gusts"));
    program.set("wind_along_x", 1);
    program.set("wind_along_z", 2);
    glActiveTexture(GL_TEXTURE1);
    glBindTexture(GL_TEXTURE_3D, along_x_);
    glActiveTexture(GL_TEXTURE2);
    glBindTexture(GL_TEXTURE_3D, along_z_);
    glActiveTexture(GL_TEXTURE0);
}
