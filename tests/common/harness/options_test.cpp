// Command lines that are refused for their values; test_command_line.py has those of wrong form.
#include "common/harness/options.hpp"

#include <gtest/gtest.h>

namespace {

Lesson lesson()
{
    Lesson lesson;
    lesson.name = "step00_test";
    lesson.variants = {{"plain", nullptr}};
    lesson.has_scene = lesson.fixed_points = true;
    return lesson;
}

CommandLine parse(std::vector<std::string> arguments)
{
    arguments.insert(arguments.begin(), "step00_test");
    std::vector<char*> argv;
    for (std::string& argument : arguments) argv.push_back(argument.data());
    return parse_command_line(int(argv.size()), argv.data(), lesson());
}

}  // namespace

// Each of them ends the program, with one line on stderr.
TEST(OptionsDeathTest, RefuseWhatMakesNoSense)
{
    const auto status = [](int expected) { return testing::ExitedWithCode(expected); };
    EXPECT_EXIT(parse({"--point-size", "nan"}), status(2), "--point-size");
    EXPECT_EXIT(parse({"--set", "gravity=nan"}), status(2), "gravity takes -30 to -0.1 m/s2");
    EXPECT_EXIT(parse({"--set", "nonsense=1"}), status(2), "nonsense");
    for (const char* camera : {"1,2", "1,2,x", "0,89,10", "nan,10,10"})
        EXPECT_EXIT(parse({"--camera", camera}), status(2), "--camera") << camera;
    for (const char* size : {"0x0", "10", "10x10x10", "10x99999999999"})
        EXPECT_EXIT(parse({"--size", size}), status(2), "--size") << size;
    EXPECT_EXIT(parse({"--voxels", "48"}), status(2), "--voxels");
}
