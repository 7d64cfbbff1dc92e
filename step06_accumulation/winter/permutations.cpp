#include "step06_accumulation/winter/permutations.hpp"

#include <string>
#include <utility>

Permutations::Permutations(std::vector<Shader> shaders, unsigned known)
    : shaders_(std::move(shaders)), known_(known)
{}

Program& Permutations::use(unsigned features)
{
    features &= known_;
    auto program = programs_.find(features);
    if (program == programs_.end()) {
        const char* const names[] = {"SHADOW",  "OCCLUSION", "LAMP",  "SPARKLE",
                                     "DUSTING", "BLUR",      "BLOOM", "WIND_FIELD"};
        std::string defines;
        for (size_t i = 0; i < std::size(names); ++i) {
            if (features >> i & 1u) defines += "#define " + std::string(names[i]) + "\n";
        }
        program =
            programs_.try_emplace(features, shaders_, std::vector<const char*>{}, defines).first;
    }
    program->second.use();
    return program->second;
}
