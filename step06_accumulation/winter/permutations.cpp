#include "step06_accumulation/winter/permutations.hpp"

#include <utility>

Permutations::Permutations(std::vector<Shader> shaders, std::vector<const char*> varyings)
    : shaders_(std::move(shaders)), varyings_(std::move(varyings))
{
    with("");
}

Program& Permutations::with(const std::string& parts)
{
    return programs_.try_emplace(parts, shaders_, varyings_, parts).first->second;
}
