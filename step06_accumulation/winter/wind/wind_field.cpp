#include "step06_accumulation/winter/wind/wind_field.hpp"

#include <algorithm>
#include <cmath>
#include <iostream>
#include <utility>

#include "common/bindings.glsl"

namespace {

using glm::ivec3;
using glm::vec3;

constexpr int n = AirFlow::cells;

size_t cell_index(ivec3 cell)
{
    return (size_t(cell.z) * n + size_t(cell.y)) * n + size_t(cell.x);
}

template <typename Function>
void for_each_cell(Function function, int end = n)
{
    for (int z = 0; z < end; ++z) {
        for (int y = 0; y < end; ++y) {
            for (int x = 0; x < end; ++x) function(ivec3(x, y, z));
        }
    }
}

ivec3 unit(int axis)
{
    ivec3 direction(0);
    direction[axis] = 1;
    return direction;
}

// The fraction of the face below `cell` along `axis` through which one can pass from the middle of
// one cell to the middle of the other.
float open_fraction(const VoxelGrid& grid, ivec3 cell, int axis)
{
    if (axis == 1 && cell.y == 0) return 0;  // the ground
    const int size = grid.resolution / n;    // of a cell, in voxels
    const int reach = std::max(1, size / 2);
    int blocked = 0;
    for (int i = 0; i < size * size; ++i) {
        ivec3 voxel = size * cell - reach * unit(axis);
        voxel[(axis + 1) % 3] += i % size;
        voxel[(axis + 2) % 3] += i / size;
        const int end = voxel[axis] + 2 * reach;
        while (voxel[axis] < end && !grid.solid(voxel)) ++voxel[axis];
        if (voxel[axis] < end) ++blocked;
    }
    return 1.0f - float(blocked) / float(size * size);
}

// Slows the air in the lee of everything, or it would close behind a wall as it parts before it:
// each layer of cells across `axis` passes on what finds a way through, mixed with the air beside
// it, as an eddy viscosity would (Counihan, Hunt and Jackson, "Wakes behind two-dimensional surface
// obstacles in turbulent boundary layers", 1974; here some 0.1 m2/s for each m/s of wind).
void add_wake(AirFlow& flow, int axis)
{
    const bool forwards = flow.speed[axis][0] > 0;
    const int across = (axis + 1) % 3, along = (axis + 2) % 3;
    std::vector<float> layer(size_t(n) * n, 1.0f),
        next(layer);  // fraction of the wind that is left
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
                const size_t face = AirFlow::face(cell);
                flow.speed[axis][face] *= mean;
                // The scene may have stood as far into the face before: only what is new stops air.
                const ivec3 before = cell + (forwards ? -1 : 1) * unit(axis);
                const float open = flow.open[axis][face];
                const float was = i == 0 ? 1.0f : flow.open[axis][AirFlow::face(before)];
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
        const size_t low = AirFlow::face(cell), high = AirFlow::face(cell + unit(axis));
        sum += flow.open[axis][high] * flow.speed[axis][high] -
               flow.open[axis][low] * flow.speed[axis][low];
    }
    return sum;
}

// The gradient of the pressure, which is 0 outside the cube, as the speeds of a flow.
void set_gradient(AirFlow& flow, const std::vector<float>& pressure)
{
    const auto at = [&](ivec3 cell) {
        const bool inside = glm::all(glm::greaterThanEqual(cell, ivec3(0))) &&
                            glm::all(glm::lessThan(cell, ivec3(n)));
        return inside ? pressure[cell_index(cell)] : 0.0f;
    };
    for (int axis = 0; axis < 3; ++axis) {
        const auto set = [&](ivec3 cell) {
            flow.speed[axis][AirFlow::face(cell)] = at(cell) - at(cell - unit(axis));
        };
        for_each_cell(set, n + 1);
    }
}

}  // namespace

vec3 AirFlow::at_cell(ivec3 cell) const
{
    vec3 mean;
    for (int axis = 0; axis < 3; ++axis) {
        const size_t low = face(cell), high = face(cell + unit(axis));
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
            flow.open[axis][AirFlow::face(cell)] = open_fraction(grid, cell, axis);
        });
        if (wind[axis] != 0) add_wake(flow, axis);
    }

    // Conjugate gradients for the pressure p: minus the divergence of open * grad p is minus that
    // of open * wind.
    const size_t count = size_t(n) * n * n;
    std::vector<float> pressure(count, 0), rest(count), direction(count), image(count);
    for_each_cell([&](ivec3 cell) { rest[cell_index(cell)] = -divergence(flow, cell); });
    AirFlow gradient = flow;
    const auto dot = [](const std::vector<float>& a, const std::vector<float>& b) {
        double sum = 0;
        for (size_t i = 0; i < a.size(); ++i) sum += double(a[i]) * double(b[i]);
        return sum;
    };
    direction = rest;
    double squared = dot(rest, rest);
    for (int iteration = 0; iteration < 500 && squared > 1e-7; ++iteration) {
        set_gradient(gradient, direction);
        for_each_cell([&](ivec3 cell) { image[cell_index(cell)] = -divergence(gradient, cell); });
        const float length = float(squared / dot(direction, image));
        for (size_t i = 0; i < count; ++i) {
            pressure[i] += length * direction[i];
            rest[i] -= length * image[i];
        }
        const double before = std::exchange(squared, dot(rest, rest));
        for (size_t i = 0; i < count; ++i)
            direction[i] = rest[i] + float(squared / before) * direction[i];
    }
    set_gradient(gradient, pressure);
    for (int axis = 0; axis < 3; ++axis) {
        for (size_t i = 0; i < flow.speed[axis].size(); ++i)
            flow.speed[axis][i] -= gradient.speed[axis][i];
    }
    for_each_cell([&](ivec3 cell) {
        flow.residual = std::max(flow.residual, std::abs(divergence(flow, cell)));
    });
    return flow;
}

const WindField::Flow& WindField::flow(int axis, float wind)
{
    const float sign = wind < 0 ? -1 : 1;
    Flow& flow = flows_[wind < 0 ? axis + 1 : axis];
    if (flow.texture != 0) return flow;
    const AirFlow air = flow_around(grid_, sign * vec3(unit(axis)));
    flow.velocity.resize(size_t(n) * n * n);
    // `sign` once more, as the shader multiplies with the wind's own.
    for_each_cell([&](ivec3 cell) { flow.velocity[cell_index(cell)] = sign * air.at_cell(cell); });
    flow.texture = make_texture();
    glBindTexture(GL_TEXTURE_3D, flow.texture);
    glTexImage3D(GL_TEXTURE_3D, 0, GL_RGB32F, n, n, n, 0, GL_RGB, GL_FLOAT, flow.velocity.data());
    glTexParameteri(GL_TEXTURE_3D, GL_TEXTURE_MIN_FILTER, GL_LINEAR);
    for (const GLenum wrap : {GL_TEXTURE_WRAP_S, GL_TEXTURE_WRAP_T, GL_TEXTURE_WRAP_R})
        glTexParameteri(GL_TEXTURE_3D, wrap, GL_CLAMP_TO_EDGE);
    std::cout << "wind: " << n << "^3 cells, largest divergence " << air.residual
              << " of the speed a cell" << std::endl;
    return flow;
}

void WindField::bind(vec3 wind)
{
    if (wind.x != 0) bind_texture(WIND_X_UNIT, GL_TEXTURE_3D, flow(0, wind.x).texture);
    if (wind.z != 0) bind_texture(WIND_Z_UNIT, GL_TEXTURE_3D, flow(2, wind.z).texture);
}

// With fixed functions, as in step 1: every other cell along x and z, every third above the ground.
void WindField::draw_arrows(vec3 wind, const glm::mat4& view, const glm::mat4& projection)
{
    const float cell_size = grid_.cell_size * float(grid_.resolution) / n;  // m
    glUseProgram(0);
    glMatrixMode(GL_PROJECTION);
    glLoadMatrixf(&projection[0][0]);
    glMatrixMode(GL_MODELVIEW);
    glLoadMatrixf(&view[0][0]);
    const vec3 eye(glm::inverse(view)[3]);  // which they are turned towards
    glBegin(GL_TRIANGLES);
    for_each_cell([&](ivec3 cell) {
        if (cell.x % 2 != 0 || cell.z % 2 != 0 || cell.y % 3 != 1 || cell.y > 12) return;
        vec3 air(0);
        for (const int axis : {0, 2})
            if (wind[axis] != 0)
                air += wind[axis] * flow(axis, wind[axis]).velocity[cell_index(cell)];
        const float speed = glm::length(air) / std::max(glm::length(wind), 0.001f);
        if (speed < 0.02f) return;
        const vec3 along = 1.6f * cell_size * std::min(speed, 1.5f) * glm::normalize(air);
        const vec3 foot = grid_.origin + cell_size * (vec3(cell) + 0.5f) - 0.5f * along;
        const vec3 across = 0.1f * cell_size * glm::normalize(glm::cross(along, eye - foot));
        glColor3f(0.5f * speed / 1.3f, 0.1f, 0.5f - 0.5f * speed / 1.3f);
        for (const vec3 corner : {foot + across, foot - across, foot + along})
            glVertex3fv(&corner.x);
    });
    glEnd();
    glColor3f(1, 1, 1);
}
