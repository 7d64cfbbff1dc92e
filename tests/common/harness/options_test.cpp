// The command line where it succeeds; test_command_line.py has the lines that fail.
#include "common/harness/options.hpp"

#include <gtest/gtest.h>

namespace {

CommandLine parse(std::vector<std::string> arguments)
{
    arguments.insert(arguments.begin(), "step00_test");
    std::vector<char*> argv;
    for (std::string& argument : arguments) argv.push_back(argument.data());
    return parse_command_line(int(argv.size()), argv.data(),
                              {.name = "step00_test",
                               .idea = "a test",
                               .minimum_gl = 1.5,
                               .variants = {{"plain", nullptr}, {"fancy", nullptr}},
                               .has_scene = true});
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
               "--scene",   "a.obj",       "--vsync",     "--frames", "5",          "--warmup",
               "2",         "--timelapse", "60",          "--camera", "-90, 45,10", "--tour"});
    EXPECT_EQ(options.variant, "fancy");
    EXPECT_EQ(options.weather.particles, 50'000'000u);
    EXPECT_EQ(options.weather.seed, 9u);
    EXPECT_EQ(options.size, glm::ivec2(640, 360));
    EXPECT_EQ(options.voxels, 64);
    EXPECT_EQ(options.up, 'z');
    EXPECT_EQ(options.scene, "a.obj");
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

TEST(Options, TakeOneStepAFrameWhenTheResultIsKept)
{
    const std::string dump = testing::TempDir() + "/snowfall_options_dump.csv";
    EXPECT_TRUE(parse({"--frames", "3"}).reproducible());
    EXPECT_TRUE(parse({"--dump", dump}).reproducible());
    EXPECT_TRUE(parse({"--screenshot", testing::TempDir() + "/last.png"}).reproducible());
    EXPECT_FALSE(parse({"--frames", "3", "--dump", dump, "--realtime"}).reproducible());
    EXPECT_TRUE(parse({"--dump", dump}).frames) << "a file of the last frame needs a last frame";
}
