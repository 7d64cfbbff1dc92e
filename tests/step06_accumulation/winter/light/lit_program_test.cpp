// What the programs for one light and for another are made of, in a real window.
#include "step06_accumulation/winter/light/lit_program.hpp"

#include <gtest/gtest.h>

#include <string>

#include "common/harness/options.hpp"
#include "common/window.hpp"

namespace {

// The fragment shader of the program in use, as the compiler got it.
std::string fragment_source()
{
    GLint program = 0, type = 0, length = 0;
    GLsizei count = 0;
    GLuint shaders[2] = {};
    glGetIntegerv(GL_CURRENT_PROGRAM, &program);
    glGetAttachedShaders(GLuint(program), 2, &count, shaders);
    glGetShaderiv(shaders[0], GL_SHADER_TYPE, &type);
    const GLuint shader = type == GL_FRAGMENT_SHADER ? shaders[0] : shaders[1];
    glGetShaderiv(shader, GL_SHADER_SOURCE_LENGTH, &length);
    std::string source(size_t(length), '\0');
    glGetShaderSource(shader, length, nullptr, source.data());
    return source;
}

bool has_uniform(const char* name)
{
    GLint program = 0;
    glGetIntegerv(GL_CURRENT_PROGRAM, &program);
    return glGetUniformLocation(GLuint(program), name) >= 0;
}

}  // namespace

// An `if` in a shader is not enough: there are drivers that compute both of its sides.
TEST(LitProgram, HasNotALineOfWhatIsOff)
{
    CommandLine command;
    command.lesson = {
        .name = "light", .idea = "a test", .minimum_gl = 4.3, .variants = {{"plain", nullptr}}};
    command.variant = "plain";
    command.weather = snow::make_weather("snow", 7, 1);
    command.size = {64, 64};
    Window window(command);
    const std::string folder = "step06_accumulation/winter/surface/";
    LitProgram lit(
        {{GL_VERTEX_SHADER, folder + "bare.vert"}, {GL_FRAGMENT_SHADER, folder + "bare.frag"}});

    snow::Light day{}, night{};
    day.has_shadow = day.has_occlusion = 1;
    night.lamp_is_on = 0.5f;
    lit.for_light(day).use();
    EXPECT_TRUE(has_uniform("shadow_map") && has_uniform("sky_seen"));
    EXPECT_EQ(fragment_source().find("#define LAMP"), std::string::npos);
    lit.for_light(night).use();
    EXPECT_FALSE(has_uniform("shadow_map") || has_uniform("sky_seen"));
    EXPECT_NE(fragment_source().find("#define LAMP"), std::string::npos);
    EXPECT_EQ(&lit.for_light(day), &lit.for_light(day));  // nothing is compiled twice
}
