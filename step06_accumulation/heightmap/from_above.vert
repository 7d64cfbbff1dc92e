#version 430 core
// The scene from straight above: x and z across, and the depth is 0 at the top of the grid, 1 at its bottom.

#include "step05_collision/grid.glsl"

layout(location = 0) in vec3 position;

void main()
{
    vec3 cells = (position - grid.origin) / grid.cell_size;
    vec3 device = 2.0 * cells / float(grid.resolution) - 1.0;
    gl_Position = vec4(device.x, device.z, -device.y, 1.0);
}
