// Finding, reading and writing files.
#include "common/harness/output.hpp"

#include <gtest/gtest.h>
#include <unistd.h>

#include <cstdlib>
#include <fstream>

#include "common/files.hpp"

namespace fs = std::filesystem;

namespace {

class Files : public testing::Test {
protected:
    void SetUp() override
    {
        folder = fs::path(testing::TempDir()) / ("snowfall_files_" + std::to_string(getpid()));
        fs::create_directories(folder);
    }
    void TearDown() override { fs::remove_all(folder); }
    size_t files_in_folder() const
    {
        return size_t(std::distance(fs::directory_iterator(folder), fs::directory_iterator()));
    }
    fs::path folder;
};

template <typename Function>
std::string message_of(Function function)
{
    try {
        function();
    } catch (const std::runtime_error& error) {
        return error.what();
    }
    return "nothing was thrown";
}

}  // namespace

TEST_F(Files, AreFoundInTheSourceTreeOrInSnowfallDir)
{
    EXPECT_NE(read_file(find_file("common/snow.glsl")).find("struct Particle"), std::string::npos);
    setenv("SNOWFALL_DIR", folder.c_str(), 1);
    std::ofstream(folder / "here.txt") << "x";
    EXPECT_EQ(find_file("here.txt"), folder / "here.txt");
    const std::string message = message_of([] { find_file("common/snow.glsl"); });
    unsetenv("SNOWFALL_DIR");
    EXPECT_NE(message.find((folder / "common/snow.glsl").string()), std::string::npos) << message;
    EXPECT_NE(message.find("SNOWFALL_DIR"), std::string::npos) << message;
}

TEST_F(Files, AreReadAndWrittenWhole)
{
    const std::string bytes("a\0b\r\n\xff", 6);
    write_file(folder / "out", "first, and longer");
    write_file(folder / "out", bytes);
    EXPECT_EQ(read_file(folder / "out"), bytes);
    EXPECT_EQ(files_in_folder(), 1u);
    EXPECT_NE(message_of([&] { write_file(folder / "none" / "out", "x"); }).find("none/out"),
              std::string::npos);
    EXPECT_NE(message_of([&] { read_file(folder / "none"); }).find("none"), std::string::npos);
    EXPECT_NE(message_of([&] { read_file(folder); }).find("cannot read"), std::string::npos);
}

TEST_F(Files, AreNotChangedByAskingWhetherTheyCanBeWritten)
{
    check_writable(folder / "new");
    EXPECT_EQ(files_in_folder(), 0u);
    std::ofstream(folder / "old") << "kept";
    check_writable(folder / "old");
    EXPECT_EQ(read_file(folder / "old"), "kept");
    EXPECT_THROW(check_writable(folder / "none" / "out"), std::runtime_error);
    EXPECT_THROW(check_writable(folder), std::runtime_error);
}

TEST_F(Files, DumpTellsAnyTwoFloatsApart)
{
    std::vector<snow::Particle> flakes(2);
    flakes[0].position.x = 0.1f;
    flakes[1].position.x = std::nextafter(0.1f, 1.0f);
    write_dump(folder / "dump.csv", flakes);
    EXPECT_EQ(read_file(folder / "dump.csv"), "index,x,y,z,age,vx,vy,vz,rest\n"
                                              "0,0.100000001,0,0,0,0,0,0,0\n"
                                              "1,0.100000009,0,0,0,0,0,0,0\n");
}
