// Where a flake's way ends in a grid of voxels: GLSL and C++, like common/snow.glsl. Whoever includes
// this has defined `bool solid(ivec3 cell)` and grid_origin (m) and cell_size (m).

// The cell that a point lies in.
SNOW_INLINE ivec3 cell_of(vec3 position)
{
    return ivec3(floor((position - grid_origin) / cell_size));
}

// The point of the cell nearest to `position`, a hair inside its faces.
SNOW_INLINE vec3 inside_cell(vec3 position, ivec3 cell)
{
    vec3 corner = grid_origin + cell_size * vec3(cell);
    return clamp(position, corner + 0.001f * cell_size, corner + 0.999f * cell_size);
}

// Follows flake p, which has just moved from `from` in a straight line, cell by cell (Amanatides and
// Woo, "A Fast Voxel Traversal Algorithm", 1987), so that no speed lets it pass through anything.
// A solid cell entered from above: it lands (or bounces) in the empty cell it came from. Entered from another side:
// it loses that component of its velocity and slides on with the rest of its way.
SNOW_INLINE Particle collide(vec3 from, Particle p, SNOW_IN(Weather) weather)
{
    for (int slides = 0; slides < 3; ++slides) {
        vec3 way = p.position - from;
        ivec3 cell = cell_of(from);
        ivec3 faces = cell_of(p.position) - cell;  // faces still to cross along each axis, signed
        // The part of the way, 0 to 1, to the next face on each axis, and from one face to the next.
        vec3 next, stride;
        for (int axis = 0; axis < 3; ++axis) {
            float face = grid_origin[axis] + cell_size * float(cell[axis] + (faces[axis] > 0 ? 1 : 0));
            next[axis] = faces[axis] == 0 ? 2.0f : (face - from[axis]) / way[axis];
            stride[axis] = faces[axis] == 0 ? 0.0f : cell_size / abs(way[axis]);
        }
        int blocked = -1;  // the axis along which a solid cell is in the way
        int direction = 0;
        while (blocked < 0 && (faces.x != 0 || faces.y != 0 || faces.z != 0)) {
            int axis = next.x < next.y ? (next.x < next.z ? 0 : 2) : (next.y < next.z ? 1 : 2);
            direction = faces[axis] > 0 ? 1 : -1;
            ivec3 ahead = cell;
            ahead[axis] += direction;
            if (solid(ahead)) {
                blocked = axis;
            } else {
                cell = ahead;
                faces[axis] -= direction;
                next[axis] = faces[axis] == 0 ? 2.0f : next[axis] + stride[axis];
            }
        }
        if (blocked < 0) return p;
        from = inside_cell(from + next[blocked] * way, cell);
        if (blocked == 1 && direction < 0) {
            p.position = from;
            return land(p, weather);
        }
        p.position[blocked] = from[blocked];
        p.velocity[blocked] = 0.0f;
    }
    p.position = from;
    return p;
}
