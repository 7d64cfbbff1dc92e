// The light of the hour: computes once a frame, for all shaders of the winter, what light.glsl
// needs.
#pragma once

#include <glm/glm.hpp>
#include <string>
#include <vector>

#include "common/uniform_block.hpp"
#include "common/weather.hpp"
#include "step05_collision/solid_scene.hpp"

namespace snow {
#include "step06_accumulation/winter/light/light.glsl"
static_assert(sizeof(Light) == 224, "the layout std140 gives it");
}  // namespace snow

class Daylight {
public:
    explicit Daylight(const SolidScene& solid);

    static std::vector<snow::Parameter> parameters();
    inline static bool shadow = true, occlusion = true, fog = true, lamp = true;
    inline static float sun_height = 20, sun_direction = 118;  // degrees

    // tick: time steps made since the first flake.
    void update(const snow::Weather& weather, unsigned tick);

    const snow::Light& light() const { return light_; }

    // Which parts of the light there are, as light.glsl wants it defined; see permutations.hpp.
    std::string parts() const;

private:
    UniformBlock<snow::Light> block_;
    snow::Light light_{};
    glm::vec3 lowest_{-1}, highest_{1};  // m, corners of a box around the scene
    glm::vec3 lamp_light_{};             // of the lamp that the scene has, when it is on
};
