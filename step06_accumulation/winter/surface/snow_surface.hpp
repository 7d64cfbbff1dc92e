// The scene as it is drawn under snow: every surface that snow can lie on is lifted by it.
#pragma once

#include <vector>

#include "common/program.hpp"
#include "common/scene/scene.hpp"
#include "common/weather.hpp"
#include "step05_collision/scene_pictures.hpp"

struct SurfaceVertex {
    Vertex vertex;
    float lift;   // 1: moves with the snow, 0: stays
    float skirt;  // 1: part of the snow's side
};

// Of one submesh of the scene. Three vertices in a row make a triangle.
struct SurfacePart {
    std::vector<SurfaceVertex> coarse;  // to be divided further, once there is snow
    std::vector<SurfaceVertex> fine;    // as it is
};

// Cuts the scene into triangles no longer than a metre, the most that tessellation can divide into
// pieces of a cell. What has no edge longer than `fine_enough`, m, or lies under no snow, is left
// alone. Where a surface that snow can lie on ends, a skirt of two triangles an edge, flat until
// snow lifts its upper side, closes the gap to what stays below: all skirts are one part more.
std::vector<SurfacePart> make_snow_surface(const Scene& scene, float fine_enough);

class SnowSurface {
public:
    SnowSurface(const Scene& scene, float cell_size);

    static std::vector<snow::Parameter> parameters();
    inline static float tessellation = 1, sparkle = 1;  // switches

    // The programs that draw it: they want the depth of the snow and the textures of light.glsl.
    std::vector<Program*> programs();
    void draw(const ScenePictures& pictures);

private:
    struct Part {
        size_t submesh;
        GLint first;  // of the vertices
        GLsizei count;
    };
    static void draw(GLenum mode, const std::vector<Part>& parts, Program& program,
                     const ScenePictures& pictures);

    GlObject buffer_, vao_;
    std::vector<Part> coarse_, fine_;
    Program untessellated_, tessellated_;
    float fine_enough_;  // m
};
