// The scene as it is drawn under snow: every surface that snow can lie on is lifted by it.
#pragma once

#include <vector>

#include "common/program.hpp"
#include "common/scene/scene.hpp"
#include "step05_collision/solid_scene.hpp"
#include "step06_accumulation/winter/permutations.hpp"

struct SurfaceVertex {
    Vertex vertex;
    float displacement;  // 1: moves with the snow, 0: stays; less than 1 where it is steep
    float skirt;         // 1: on the snow's side
    glm::vec3 even_normal{0, 1, 0};  // of deep snow, which fills the hollows of the surface
};

// Three vertices in a row make a triangle.
struct SurfaceSubmesh {
    std::vector<SurfaceVertex> bare;    // no snow can lie on it
    std::vector<SurfaceVertex> fine;    // lifted as it is
    std::vector<SurfaceVertex> coarse;  // to be divided further, once there is snow
};

// Cuts the scene into triangles no longer than a metre, the most that tessellation can divide into
// pieces of a cell, or than `fine_enough`, m. Where a surface that snow can lie on ends, a skirt of
// two triangles an edge, flat until snow lifts its upper side, closes the gap to what stays below.
// Returns one for each submesh of the scene, and one more, of all skirts.
std::vector<SurfaceSubmesh> make_snow_surface(const Scene& scene, float fine_enough);

// The field around the grid's cube (with_middle: in it, too) as far as one sees, in rings: the
// innermost, which is coarse, joins the ground in the cube, and frame.field_depth lifts the others.
SurfaceSubmesh make_field(const VoxelGrid& grid, bool with_middle);

class SnowSurface {
public:
    explicit SnowSurface(const SolidScene& solid);

    // Draws it with these features (permutations.hpp), what snow bends tessellated or not.
    void draw(unsigned features, bool tessellated);

private:
    struct Range {
        size_t submesh;
        size_t first;  // of the indices
        GLsizei count;
    };
    void draw(GLenum mode, const std::vector<Range>& ranges, Program& program) const;

    const SolidScene& solid_;
    GlObject vertices_, indices_, vao_;
    std::vector<Range> bare_, fine_, coarse_, field_;
    Permutations on_bare_, on_field_, on_snow_, on_snow_tessellated_;
};
