// Where a flake's way ends in a grid of voxels: GLSL and C++, like common/snow.glsl, over a `grid` of
// voxels (grid.glsl) and what counts as solid in it.

bool solid(ivec3 cell);

// The cell that a point lies in.
SNOW_INLINE ivec3 cell_of(vec3 position)
{
    return ivec3(floor((position - grid.origin) / grid.cell_size));
}

// The point of the cell nearest to `position`, a hair inside its faces and not below the ground.
SNOW_INLINE vec3 inside_cell(vec3 position, ivec3 cell)
{
    vec3 corner = grid.origin + grid.cell_size * vec3(cell);
    vec3 inside = clamp(position, corner + 0.001f * grid.cell_size, corner + 0.999f * grid.cell_size);
    inside.y = max(inside.y, 0.0f);
    return inside;
}

// Follows flake p, which has just moved from `from` in a straight line, cell by cell (Amanatides
// and Woo, "A Fast Voxel Traversal Algorithm", 1987), so that no speed lets it pass through
// anything. A solid cell entered from above: it lands (or bounces) in the empty cell it came from.
// Entered from another side: it loses that component of its velocity and slides on with the rest of
// its way.
SNOW_INLINE Particle collide(vec3 from, Particle p, SNOW_IN(Weather) weather)
{
    const float finished = 2.0f;  // for an axis without a face to cross: more than any fraction
    for (int slides = 0; slides < 3; ++slides) {
        vec3 way = p.position - from;
        ivec3 cell = cell_of(from);
        ivec3 faces = cell_of(p.position) - cell;  // still to cross along each axis, signed
        // The fraction of the way at which it crosses the next face along each axis, and the fraction from one
        // face to the next. Clamped: where the way is as short as a rounding error, so is its divisor.
        vec3 t_max, t_delta;
        for (int axis = 0; axis < 3; ++axis) {
            float face = grid.origin[axis] + grid.cell_size * float(cell[axis] + (faces[axis] > 0 ? 1 : 0));
            t_max[axis] = faces[axis] == 0 ? finished : clamp((face - from[axis]) / way[axis], 0.0f, 1.0f);
            t_delta[axis] = faces[axis] == 0 ? 0.0f : grid.cell_size / abs(way[axis]);
        }
        int blocked = -1;  // the axis along which a solid cell is in the way
        int direction = 0;
        int crossings = abs(faces.x) + abs(faces.y) + abs(faces.z);
        for (; blocked < 0 && crossings > 0; --crossings) {
            int axis = t_max.x < t_max.y ? (t_max.x < t_max.z ? 0 : 2) : (t_max.y < t_max.z ? 1 : 2);
            direction = faces[axis] > 0 ? 1 : -1;
            ivec3 ahead = cell;
            ahead[axis] += direction;
            if (solid(ahead)) {
                blocked = axis;
            } else {
                cell = ahead;
                faces[axis] -= direction;
                t_max[axis] = faces[axis] == 0 ? finished : min(t_max[axis] + t_delta[axis], 1.0f);
            }
        }
        if (blocked < 0) return p;
        from = inside_cell(from + t_max[blocked] * way, cell);
        if (blocked == 1 && direction < 0) {
            p.position = from;
            return land(p, weather);
        }
        p.position[blocked] = from[blocked];
        p.velocity[blocked] = 0.0f;
    }
    p.position = from;  // blocked along all three axes: in a corner, under a ceiling
    return p;
}
