// Programs of the same shaders, one for each set of features that are on. What is off is not in the
// program at all: on a card a branch on a uniform would do as well, but some drivers, software ones
// most of all, compute both sides of it.
#pragma once

#include <map>
#include <vector>

#include "common/program.hpp"
#include "step06_accumulation/winter/settings.hpp"

// What shaders may have besides: bits of a set. Each is a #define of its own name in the shaders.
inline constexpr unsigned SHADOW = 1,  // the shadow map
    OCCLUSION = 2,                     // the scene hides some of the sky
    LAMP = 4,                          // a lamp that is on
    SPARKLE = 8,                       // crystals on the snow that flash
    DUSTING = 16,                      // snow on the weather side of walls
    BLUR = 32,                         // flakes close by are out of focus
    BLOOM = 64,                        // light around what is bright
    WIND_FIELD = 128,                  // the air flows around the scene
    TESSELLATED = 256,                 // tessellation follows the vertex shader
    WET = 512;                         // rain, and what lies open to it

// Those that are on.
unsigned features_of(const Settings& settings, const snow::Weather& weather);

class Permutations {
public:
    // known: the features that these shaders ask for.
    explicit Permutations(std::vector<Shader> shaders, unsigned known = 0);

    // Puts the program with these features to use; it is compiled when it is first wanted.
    Program& use(unsigned features);

private:
    std::vector<Shader> shaders_;
    unsigned known_;
    std::map<unsigned, Program> programs_;  // by their features
};
