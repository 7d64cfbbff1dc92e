// Programs whose shaders include light.glsl, and get the textures that it looks light up in.
#pragma once

#include <functional>
#include <map>
#include <string>
#include <vector>

#include "common/program.hpp"
#include "step06_accumulation/winter/light/daylight.hpp"

class LitProgram {
public:
    // Compiles the program for all that there can be, so that a fault is told at once. Throws as
    // Program does.
    explicit LitProgram(std::vector<Shader> shaders);

    // The program for this light, compiled when it is first asked for: of what is off it has not a
    // line, so that costs nothing.
    Program& for_light(const snow::Light& light);

private:
    std::vector<Shader> shaders_;
    std::map<std::string, Program> programs_;  // by what is defined for their shaders
};

// Puts a program for the light of this frame to use, with its textures.
using UseLit = std::function<Program&(LitProgram&)>;
