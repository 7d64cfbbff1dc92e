// The flakes as they are drawn: crystals, drops or hailstones, drawn out along their way; or the
// sprites of step 3.
#pragma once

#include <functional>
#include <vector>

#include "common/program.hpp"
#include "common/window.hpp"
#include "step06_accumulation/winter/permutations.hpp"

class Flakes {
public:
    Flakes();

    static std::vector<snow::Parameter> parameters();
    inline static bool billboards = true, splashes = true, blur = true, sorted = false;
    inline static float colours = 0;  // 0 their own, 1 by speed, 2 by age, 3 by emitter

    // Draws what draw_points draws as points, a flake each.
    void draw(const Window& window, const UseProgram& use_lit,
              const std::function<void()>& draw_points);

private:
    Permutations billboard_, splash_;
    Program sprite_;
    GlObject crystals_;
};
