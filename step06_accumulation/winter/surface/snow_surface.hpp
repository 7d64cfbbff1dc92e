// The scene as it is drawn under snow: every surface that snow can lie on is lifted by it.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "common/program.hpp"
#include "common/scene/scene.hpp"
#include "common/weather.hpp"
#include "step05_collision/solid_scene.hpp"
#include "step06_accumulation/winter/permutations.hpp"

struct SurfaceVertex {
    Vertex vertex;
    float lift;   // 1: moves with the snow, 0: stays; less than 1 where it is steep
    float skirt;  // 1: part of the snow's side
    // Of the surface when deep snow has filled its hollows: the normal, and how far above it lies,
    // m. See hollows.hpp.
    glm::vec4 even{0, 1, 0, 0};
};

// Of one submesh of the scene. Three vertices in a row make a triangle.
struct SurfacePart {
    std::vector<SurfaceVertex> bare;    // no snow can lie on it
    std::vector<SurfaceVertex> fine;    // lifted as it is
    std::vector<SurfaceVertex> coarse;  // to be divided further, once there is snow
};

// Cuts the scene into triangles no longer than a metre, the most that tessellation can divide into
// pieces of a cell. What has no edge longer than `fine_enough`, m (in a large scene more than a
// metre), or lies under no snow, is left alone. Where a surface that snow can lie on ends, a skirt
// of two triangles an edge, flat until snow lifts its upper side, closes the gap to what stays
// below: all skirts are one part more.
std::vector<SurfacePart> make_snow_surface(const Scene& scene, float fine_enough);

// The field around the grid's cube as far as one sees, in rings: the innermost, which is to be
// divided, joins the squares of the ground in the cube, and the others nothing lifts but the snow
// on open ground. with_middle: in the cube, too.
SurfacePart make_field(const VoxelGrid& grid, bool with_middle);

class SnowSurface {
public:
    explicit SnowSurface(const SolidScene& solid);

    static std::vector<snow::Parameter> parameters();
    inline static bool scene = true, tessellation = true, dusting = true, sparkle = true;

    // set_snow gives a program in use the textures of the snow.
    void draw(const snow::Weather& weather, const ScenePictures& pictures,
              const UseProgram& use_lit, const std::function<void(Program&)>& set_snow);

private:
    struct Part {
        size_t submesh;
        size_t first;  // of the indices
        GLsizei count;
    };
    struct Programs {  // for surfaces that snow can lie on
        Permutations as_is, tessellated;
    };
    static Programs programs_with(const std::string& fragment_shader);
    static void draw(GLenum mode, const std::vector<Part>& parts, Program& program,
                     const ScenePictures* pictures = nullptr);

    GlObject vertices_, indices_, vao_;
    std::vector<Part> bare_, fine_, coarse_, field_;
    Permutations on_bare_, on_dusted_, on_field_;
    Programs plain_, sparkling_;
    GlObject grain_;
    float fine_enough_;  // m
};
