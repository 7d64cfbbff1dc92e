// Writing files; test_output.py has what fails.
#include "common/harness/output.hpp"

#include <gtest/gtest.h>
#include <unistd.h>

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
    fs::path folder;
};

}  // namespace

TEST_F(Files, AreWrittenThroughLinks)
{
    std::ofstream(folder / "target") << "old, and longer";
    fs::create_symlink(folder / "target", folder / "link");
    write_file(folder / "link", "new");
    EXPECT_TRUE(fs::is_symlink(folder / "link"));
    EXPECT_EQ(read_file(folder / "target"), "new");
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
