// Where in the world the voxel grid lies.

uniform vec3 grid_origin;  // m, the corner of least x, y and z
uniform float cell_size;   // m
uniform int resolution;    // voxels along each edge
