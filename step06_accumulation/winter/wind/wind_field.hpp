// The wind around the scene: how air that would blow evenly flows past what stands in its way.
#pragma once

#include <glm/glm.hpp>
#include <vector>

#include "common/gl_object.hpp"
#include "step05_collision/voxel_grid.hpp"

// Air that blows with 1 m/s along one axis far from the scene. Its velocity is known on the faces
// of a coarse grid: component `axis` at face (i, j, k) is the flow from cell i-1 to cell i along
// that axis.
struct AirFlow {
    static constexpr int cells = 32;  // along each edge of the voxel grid's cube
    std::vector<float> speed[3];      // m/s, (cells + 1)^3 values each
    std::vector<float> open[3];       // fraction of the face that the scene leaves free, 0 to 1
    float residual;  // largest net flow out of a cell, relative to that through a face

    static size_t face(glm::ivec3 cell)  // the index of its lower face
    {
        return (size_t(cell.z) * (cells + 1) + size_t(cell.y)) * (cells + 1) + size_t(cell.x);
    }
    glm::vec3 at_cell(glm::ivec3 cell) const;  // m/s, the mean of the cell's faces
};

// Takes the even wind, slows it in the lee of everything (wakes as in Rockle's wind model for
// cities, 1990), and removes from it, by the gradient of a pressure, what would flow into or out of
// any cell (the projection of Stam, "Stable Fluids", 1999). Only through the ground no air can
// leave the cube.
AirFlow flow_around(const VoxelGrid& grid, glm::vec3 wind);

// The flow for wind towards +x, -x, +z and -z, each computed when it is first wanted. Any wind is a
// sum of two of them: but for the wakes, the equations are linear.
class WindField {
public:
    explicit WindField(const VoxelGrid& grid) : grid_(grid) {}

    // Hands the shaders (wind_field.glsl) the flows that make up this wind, m/s.
    void bind(glm::vec3 wind);

    // Draws the wind as arrows, the redder the faster. view, projection: of the camera.
    void draw_arrows(glm::vec3 wind, const glm::mat4& view, const glm::mat4& projection);

private:
    struct Flow {
        std::vector<glm::vec3> velocity;  // m/s in each cell
        GlObject texture;                 // the same on the GPU
    };
    const Flow& flow(int axis, float wind);  // of its sign, along x or z

    const VoxelGrid& grid_;
    Flow flows_[4];
};
