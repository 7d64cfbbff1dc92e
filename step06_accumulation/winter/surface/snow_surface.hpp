// The scene as it is drawn under snow: every surface that snow can lie on is lifted by it.
#pragma once

#include <vector>

#include "common/program.hpp"
#include "common/scene/scene.hpp"
#include "common/weather.hpp"

struct SurfaceVertex {
    Vertex vertex;
    float lift;   // 1: moves with the snow, 0: stays
    float skirt;  // 1: part of the snow's side
};

// Three vertices in a row make a triangle.
struct SurfaceMesh {
    std::vector<SurfaceVertex> coarse;  // to be divided further, once there is snow
    std::vector<SurfaceVertex> fine;    // as it is
};

// Cuts the scene into triangles no longer than a metre, the most that tessellation can divide into
// pieces of a cell. What has no edge longer than `fine_enough`, m, or lies under no snow, is left
// alone. Where a surface that snow can lie on ends, a skirt of two triangles an edge, flat until
// snow lifts its upper side, closes the gap to what stays below.
SurfaceMesh make_snow_surface(const Scene& scene, float fine_enough);

class SnowSurface {
public:
    SnowSurface(const Scene& scene, float cell_size);

    static std::vector<snow::Parameter> parameters();
    inline static float tessellation = 1, sparkle = 1;  // switches

    // The programs that draw it: they want the depth of the snow and the textures of light.glsl.
    std::vector<Program*> programs();
    void draw();

private:
    GlObject buffer_, vao_;
    GLsizei coarse_ = 0, fine_ = 0;  // vertices, in the order in which they are stored
    Program untessellated_, tessellated_;
    float fine_enough_;  // m
};
