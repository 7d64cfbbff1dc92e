#include "step06_accumulation/winter/permutations.hpp"

#include <string>
#include <utility>

unsigned features_of(const Settings& s, const snow::Weather& weather)
{
    const bool windy = weather.wind.x != 0 || weather.wind.z != 0;
    const bool lamp = s.lamp && s.sun_height < Settings::lamp_off_height;
    return (s.shadow ? SHADOW : 0) | (s.occlusion ? OCCLUSION : 0) | (lamp ? LAMP : 0) |
           (s.sparkle ? SPARKLE : 0) | (s.dusting && windy ? DUSTING : 0) | (s.blur ? BLUR : 0) |
           (s.bloom > 0 ? BLOOM : 0) | (s.wind_field && windy ? WIND_FIELD : 0) |
           (weather.kind == snow::rain_kind ? WET : 0);
}

Permutations::Permutations(std::vector<Shader> shaders, unsigned known)
    : shaders_(std::move(shaders)), known_(known)
{}

Program& Permutations::use(unsigned features)
{
    features &= known_;
    auto program = programs_.find(features);
    if (program == programs_.end()) {
        const char* const names[] = {"SHADOW", "OCCLUSION", "LAMP",       "SPARKLE",     "DUSTING",
                                     "BLUR",   "BLOOM",     "WIND_FIELD", "TESSELLATED", "WET"};
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
