// The scene as it is seen from above: how high it stands in each column of the grid. Nothing is known of what is
// below that.

#include "step05_collision/grid.glsl"

layout(binding = HEIGHTS_UNIT) uniform sampler2D heights;  // the depth buffer of from_above.vert

// The column that a point lies in, along x and z.
ivec2 column_of(vec3 position)
{
    return ivec2(floor((position.xz - grid.origin.xz) / grid.cell_size));
}

bool in_map(ivec2 column)
{
    return all(greaterThanEqual(column, ivec2(0))) && all(lessThan(column, ivec2(grid.resolution)));
}

int index_of(ivec2 column)
{
    return column.x + grid.resolution * column.y;
}

// m, without snow; beside the scene, of the ground.
float height_at(ivec2 column)
{
    float depth = in_map(column) ? texelFetch(heights, column, 0).r : 1.0;
    return max(grid.origin.y + (1.0 - depth) * grid.cell_size * float(grid.resolution), 0.0);
}
