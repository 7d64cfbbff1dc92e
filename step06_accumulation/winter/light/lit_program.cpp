#include "step06_accumulation/winter/light/lit_program.hpp"

#include <utility>

LitProgram::LitProgram(std::vector<Shader> shaders) : shaders_(std::move(shaders))
{
    snow::Light all{};
    all.has_shadow = all.has_occlusion = all.lamp_is_on = 1;
    for_light(all);
}

Program& LitProgram::for_light(const snow::Light& light)
{
    std::string parts;
    if (light.has_shadow != 0) parts += "#define SHADOW\n";
    if (light.has_occlusion != 0) parts += "#define OCCLUSION\n";
    if (light.lamp_is_on != 0) parts += "#define LAMP\n";
    const std::vector<const char*> no_varyings;
    return programs_.try_emplace(parts, shaders_, no_varyings, parts).first->second;
}
