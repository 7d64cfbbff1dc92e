// The flakes as they are drawn: crystals, drops or hailstones, drawn out along their way; or the
// sprites of step 3.
#pragma once

#include <vector>

#include "common/program.hpp"
#include "common/window.hpp"

class Flakes {
public:
    Flakes();

    static std::vector<snow::Parameter> parameters();
    inline static float billboards = 1, splashes = 1;  // switches

    Program billboard;  // wants the textures of light.glsl

    // Takes the program into use that draws points as flakes.
    void use(const Window& window);

private:
    Program sprite_;
    GlObject crystals_;
};
