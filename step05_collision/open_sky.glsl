// Does nothing solid stand at this point, or anywhere above it? Only flakes that come in ask (release.glsl), so
// the answer may take a walk.

bool open_sky(vec3 position)
{
    for (ivec3 cell = cell_of(position); cell.y < grid.resolution; ++cell.y) {
        if (solid(cell)) return false;
    }
    return true;
}
