// The command line where it succeeds; test_command_line.py has the lines that fail.
#include "common/harness/options.hpp"

#include <gtest/gtest.h>

namespace {

bool a_switch = true;

Lesson lesson()
{
    Lesson lesson;
    lesson.name = "step00_test";
    lesson.variants = {{"plain", nullptr},
                       {"fancy",
                        nullptr,
                        {{"a_name_of_more_letters_than_most", "", "on/off", 0, 1, "", &a_switch}}}};
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

TEST(Options, HaveTheirDefaults)
{
    const CommandLine options = parse({});
    EXPECT_EQ(options.variant, "plain");
    EXPECT_EQ(options.weather.particles, 20000u);
    EXPECT_EQ(options.size, glm::ivec2(1280, 720));
    EXPECT_EQ(options.voxels, 256);
    EXPECT_EQ(options.up, 'y');
    EXPECT_EQ(options.timelapse, 1u);
    EXPECT_FALSE(options.tour);
    EXPECT_FALSE(options.vsync);
    EXPECT_FALSE(options.frames);
    EXPECT_FALSE(options.reproducible());
}

TEST(Options, ScenesThatAreBuiltInHaveNames)
{
    EXPECT_EQ(parse({"--scene", "courtyard"}).scene, parse({}).scene);
    const CommandLine mountains = parse({"--scene", "mountains"});
    EXPECT_NE(mountains.scene, parse({}).scene);
    EXPECT_TRUE(mountains.metres);
    EXPECT_EQ(mountains.weather.follow, 1u);
}

TEST(Options, AreTakenFromTheCommandLine)
{
    const CommandLine options =
        parse({"--variant", "fancy",       "--particles", "50000000", "--seed",     "9",
               "--size",    "640x360",     "--voxels",    "64",       "--up",       "z",
               "--scene",   "none",        "--vsync",     "--frames", "5",          "--warmup",
               "2",         "--timelapse", "60",          "--camera", "-90, 45,10", "--tour"});
    EXPECT_EQ(options.variant, "fancy");
    EXPECT_EQ(options.weather.particles, 50'000'000u);
    EXPECT_EQ(options.weather.seed, 9u);
    EXPECT_EQ(options.size, glm::ivec2(640, 360));
    EXPECT_EQ(options.voxels, 64);
    EXPECT_EQ(options.up, 'z');
    EXPECT_EQ(options.scene, "none");
    EXPECT_TRUE(options.vsync);
    EXPECT_EQ(options.frames, 5u);
    EXPECT_EQ(options.warmup, 2u);
    EXPECT_EQ(options.timelapse, 60u);
    EXPECT_TRUE(options.tour);
    const glm::vec3 from_the_left = options.camera.target + glm::vec3(-7.07f, 7.07f, 0);
    EXPECT_NEAR(glm::distance(options.camera.eye(), from_the_left), 0, 0.01);
}

TEST(Options, SetTheWeather)
{
    const CommandLine options =
        parse({"--weather", "hail", "--set", "wind_x=-3.5", "--set", "melt_time=1"});
    EXPECT_EQ(options.weather.emitters[0].terminal_speed,
              snow::make_weather("hail", 0, 0).emitters[0].terminal_speed);
    EXPECT_EQ(options.weather.wind, glm::vec3(-3.5f, 0, 0));
    EXPECT_EQ(options.weather.melt_time, 1);
}

TEST(Options, TurnSwitchesOnAndOff)
{
    parse({"--variant", "fancy", "--set", "a_name_of_more_letters_than_most=0"});
    EXPECT_FALSE(a_switch);
    parse({"--variant", "fancy", "--set", "a_name_of_more_letters_than_most=1"});
    EXPECT_TRUE(a_switch);
}

// Each of them ends the program, with one line on stderr or with the help.
TEST(OptionsDeathTest, RefuseWhatMakesNoSense)
{
    const auto status = [](int expected) { return testing::ExitedWithCode(expected); };
    EXPECT_EXIT(parse({"--point-size", "nan"}), status(2), "--point-size");
    EXPECT_EXIT(parse({"--set", "gravity=nan"}), status(2), "gravity takes -30 to -0.1 m/s2");
    EXPECT_EXIT(parse({"--set", "nonsense=1"}), status(2), "nonsense");
    EXPECT_EXIT(parse({"--variant", "fancy", "--set", "a_name_of_more_letters_than_most=0.5"}),
                status(2), "0 to 1 on/off");
    EXPECT_EXIT(parse({"--variant", "fancy", "--help"}), status(0), "");
    for (const char* camera : {"1,2", "1,2,3,4", "1,2,x", "0,89,10", "0,10,0", "nan,10,10"})
        EXPECT_EXIT(parse({"--camera", camera}), status(2), "--camera") << camera;
    for (const char* size : {"0x0", "10", "10x", "10x10x10", "-5x5", "10x99999999999"})
        EXPECT_EXIT(parse({"--size", size}), status(2), "--size") << size;
    EXPECT_EXIT(parse({"--voxels", "48"}), status(2), "--voxels");
    EXPECT_EXIT(parse({"--dump", ""}), status(2), "--dump");
    EXPECT_THROW(parse({"--scene", "moutains"}), std::runtime_error);
}

TEST(Options, TakeOneStepAFrameWhenTheResultIsKept)
{
    const std::string dump = testing::TempDir() + "/snowfall_options_dump.csv";
    EXPECT_TRUE(parse({"--frames", "3"}).reproducible());
    EXPECT_TRUE(parse({"--dump", dump}).reproducible());
    EXPECT_TRUE(parse({"--screenshot", testing::TempDir() + "/last.png"}).reproducible());
    EXPECT_FALSE(parse({"--frames", "3", "--dump", dump, "--realtime"}).reproducible());
    EXPECT_TRUE(parse({"--dump", dump}).frames) << "a file of the last frame needs a last frame";
}
