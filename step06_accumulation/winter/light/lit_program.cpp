#include "step06_accumulation/winter/light/lit_program.hpp"

Program& LitProgram::for_light(const snow::Light& light)
{
    std::string parts;
    if (light.has_shadow != 0) parts += "#define SHADOW\n";
    if (light.has_occlusion != 0) parts += "#define OCCLUSION\n";
    if (light.lamp_is_on != 0) parts += "#define LAMP\n";
    const std::vector<const char*> no_varyings;
    return programs_.try_emplace(parts, shaders_, no_varyings, parts).first->second;
}
