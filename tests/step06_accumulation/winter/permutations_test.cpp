// What the programs of one set of features and of another are made of, in a real window.
#include "step06_accumulation/winter/permutations.hpp"

#include <gtest/gtest.h>

#include "common/window.hpp"
#include "tests/common/harness/small_window.hpp"

// An `if` in a shader is not enough: there are drivers that compute both of its sides.
TEST(Permutations, HaveNotALineOfWhatIsOff)
{
    const Harness window(small_window(4.3));
    const std::string folder = "step06_accumulation/winter/surface/";
    Permutations all(
        {{GL_VERTEX_SHADER, folder + "bare.vert"}, {GL_FRAGMENT_SHADER, folder + "bare.frag"}},
        SHADOW | OCCLUSION);

    const auto has_texture = [&](unsigned features, const char* name) {
        all.use(features);
        GLint program = 0;
        glGetIntegerv(GL_CURRENT_PROGRAM, &program);
        return glGetUniformLocation(GLuint(program), name) >= 0;
    };
    EXPECT_TRUE(has_texture(SHADOW | OCCLUSION, "shadow_map"));
    EXPECT_TRUE(has_texture(SHADOW | OCCLUSION, "sky_visibility"));
    EXPECT_FALSE(has_texture(SHADOW, "sky_visibility"));
    EXPECT_FALSE(has_texture(OCCLUSION, "shadow_map"));
    EXPECT_FALSE(has_texture(0, "shadow_map"));
    // Nothing is compiled twice, nor for what the shaders do not ask for.
    EXPECT_EQ(&all.use(SHADOW), &all.use(SHADOW | BLOOM));
}
