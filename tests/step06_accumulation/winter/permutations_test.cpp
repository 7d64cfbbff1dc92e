// What the programs of one permutation and of another are made of, in a real window.
#include "step06_accumulation/winter/permutations.hpp"

#include <gtest/gtest.h>

#include "common/window.hpp"
#include "tests/common/harness/small_window.hpp"

// An `if` in a shader is not enough: there are drivers that compute both of its sides.
TEST(Permutations, HaveNotALineOfWhatIsOff)
{
    const Window window(small_window(4.3));
    const std::string folder = "step06_accumulation/winter/surface/";
    Permutations all(
        {{GL_VERTEX_SHADER, folder + "bare.vert"}, {GL_FRAGMENT_SHADER, folder + "bare.frag"}});

    const auto has_texture = [&](const std::string& parts, const char* name) {
        all.with(parts).use();
        GLint program = 0;
        glGetIntegerv(GL_CURRENT_PROGRAM, &program);
        return glGetUniformLocation(GLuint(program), name) >= 0;
    };
    const std::string shadow = "#define SHADOW\n", occlusion = "#define OCCLUSION\n";
    EXPECT_TRUE(has_texture(shadow + occlusion, "shadow_map"));
    EXPECT_TRUE(has_texture(shadow + occlusion, "sky_seen"));
    EXPECT_FALSE(has_texture(shadow, "sky_seen"));
    EXPECT_FALSE(has_texture(occlusion, "shadow_map"));
    EXPECT_FALSE(has_texture("", "shadow_map"));
    EXPECT_EQ(&all.with(shadow), &all.with(shadow));  // nothing is compiled twice
}
