// The light of the hour: computes once a frame, for all shaders of step 6, what light.glsl needs.
#pragma once

#include <GL/glew.h>

#include <glm/glm.hpp>

#include "common/gl_object.hpp"
#include "common/options.hpp"
#include "step05_collision/solid_scene.hpp"

namespace snow {
#include "step06_accumulation/light.glsl"
static_assert(sizeof(Light) == 224, "the layout std140 gives it");
}  // namespace snow

class Lighting {
public:
    explicit Lighting(const SolidScene& solid);

    // step: physics steps made since the first flake. Reads the settings sun_height, sun_direction,
    // exposure, shadow, occlusion, fog and lamp.
    void update(const Options& options, unsigned step);

    const snow::Light& light() const { return light_; }

private:
    GlObject buffer_;
    snow::Light light_{};
    float reach_ = 1;   // m, of the scene from the world's origin
    glm::vec3 lamp_{};  // light of the lamp that the scene has, when it is on
};
