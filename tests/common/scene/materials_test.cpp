// Colours of scenes: found in all kinds of MTL files, and not lost without a word.
#include "common/scene/materials.hpp"

#include <algorithm>

#include "tests/common/scene/scene_file.hpp"

using glm::vec3;

namespace {

const vec3 red(0.75f, 0.25f, 0.125f), grey(0.5f);
const std::string red_brick = "newmtl brick\nKd 0.75 0.25 0.125\n";

size_t lines(const std::string& text)
{
    return size_t(std::count(text.begin(), text.end(), '\n'));
}

class SceneMaterials : public SceneFile {
protected:
    // The colour of a square that these statements give a material to.
    vec3 colour(const std::string& mtllib, const std::string& usemtl = "usemtl brick\n")
    {
        return load(mtllib + square + usemtl + "f 1 2 3 4\n").corner(0).colour;
    }

    // Of the material "brick" with these statements in the MTL file.
    vec3 colour_of(const std::string& statements)
    {
        write("m.mtl", "newmtl brick\n" + statements);
        return colour("mtllib m.mtl\n");
    }
};

}  // namespace

TEST_F(SceneMaterials, LieBesideTheScene)
{
    write("m.mtl", red_brick);
    const Scene scene =
        load("mtllib m.mtl\n" + square + "usemtl brick\nf 1 2 3\nusemtl none\nf 1 3 4\n");
    EXPECT_EQ(scene.corner(0).colour, grey) << "drawn material by material";
    EXPECT_EQ(scene.corner(5).colour, red);
    EXPECT_EQ(warnings, "warning: " + (folder / "scene.obj").string() +
                            ": line 8: 'usemtl none': no such material, grey instead\n");
}

TEST_F(SceneMaterials, AreFoundForASceneNamedWithoutAFolder)
{
    write("m.mtl", red_brick);
    write("scene.obj", "mtllib m.mtl\n" + square + "usemtl brick\nf 1 2 3 4\n");
    const auto before = std::filesystem::current_path();
    std::filesystem::current_path(folder);
    const Scene scene = load_file("scene.obj");
    std::filesystem::current_path(before);
    EXPECT_EQ(scene.corner(0).colour, red);
    EXPECT_EQ(warnings, "");
}

TEST_F(SceneMaterials, MayHaveOddFileNames)
{
    write("two words.mtl", red_brick);
    write("parts/b.mtl", red_brick);
    write("number #1.mtl", red_brick);
    for (const char* name :
         {"two words.mtl", "two words.mtl  ", "TWO Words.MTL", "parts/b.mtl", "parts\\b.mtl",
          "./parts/b.mtl", ".\\Parts\\B.mtl", "number #1.mtl", "C:\\work\\two words.mtl",
          "none.mtl parts/b.mtl", "parts/b.mtl # a comment", "parts/b.mtl \\\n"}) {
        EXPECT_EQ(colour("mtllib " + std::string(name) + "\n"), red) << name;
        EXPECT_EQ(warnings, "") << name;
    }
}

TEST_F(SceneMaterials, MayHaveOddNames)
{
    write("m.mtl", "\xEF\xBB\xBF"
                   "newmtl red brick\r\nKd 0.75 0.25 0.125\r\n"
                   "newmtl brick #1\r\nKd 0.1 0 0\r\nnewmtl brick #2 \r\nKd 0.2 0 0\r\n"
                   "newmtl Wood\\Oak # brown\r\nKd 0.3 0 0\r\n");
    const std::string mtllib = "mtllib m.mtl\n";
    EXPECT_EQ(colour(mtllib, "usemtl red brick\n"), red);
    EXPECT_EQ(colour(mtllib, "usemtl  red brick\t\n"), red);
    EXPECT_EQ(colour(mtllib, "usemtl Red Brick # a comment\n"), red);
    EXPECT_EQ(colour(mtllib, "usemtl brick #1\n"), vec3(0.1f, 0, 0));
    EXPECT_EQ(colour(mtllib, "usemtl brick #2\n"), vec3(0.2f, 0, 0));
    EXPECT_EQ(colour(mtllib, "usemtl wood\\oak\n"), vec3(0.3f, 0, 0));
    EXPECT_EQ(warnings, "");
}

TEST_F(SceneMaterials, MayComeFromSeveralFiles)
{
    write("a.mtl", red_brick);
    write("b.mtl", "newmtl brick\nKd 0 1 0\nnewmtl wood\nKd 0 0 1\n");
    const std::string mtllib = "mtllib a.mtl b.mtl\nmtllib a.mtl\n";
    EXPECT_EQ(colour(mtllib), red) << "the first of a name counts";
    EXPECT_EQ(colour(mtllib, "usemtl wood\n"), vec3(0, 0, 1));
    EXPECT_EQ(warnings, "");
}

TEST_F(SceneMaterials, AreMissedOnceForEachKindOfLoss)
{
    EXPECT_EQ(
        colour("mtllib none.mtl\nmtllib none either.mtl\n", "usemtl brick\nf 1 2 3\nusemtl wood\n"),
        grey);
    EXPECT_EQ(lines(warnings), 2u);
    EXPECT_NE(warnings.find("line 1: 'mtllib none.mtl': no such file"), std::string::npos);
    EXPECT_NE(warnings.find("line 7: 'usemtl brick': no such material"), std::string::npos);
    EXPECT_NE(warnings.find("(and 1 more)"), std::string::npos);
}

TEST_F(SceneMaterials, AreMissedIfTheirFileCannotBeRead)
{
    write("binary.mtl", std::string("newmtl brick\n\0", 14));
    for (const char* name : {".", "/dev/zero", "binary.mtl"}) {
        EXPECT_EQ(colour("mtllib " + std::string(name) + "\n"), grey);
        EXPECT_EQ(lines(warnings), 2u) << warnings;
        EXPECT_NE(warnings.find("line 1: 'mtllib " + std::string(name)), std::string::npos);
    }
}

TEST_F(SceneMaterials, AreGreyWithoutAColour)
{
    EXPECT_EQ(colour_of("Ka 0.2 0.2 0.2\nNs 10\n"), grey);
    EXPECT_EQ(warnings, "");
    EXPECT_EQ(colour_of("Kd 0 0 0\n"), vec3(0));
    EXPECT_EQ(warnings, "");
    EXPECT_EQ(colour_of("Kd 0.25 # the same in all three\n"), vec3(0.25f));
    EXPECT_EQ(warnings, "");
    for (const char* statement : {"Kd\n", "Kd x\n", "Kd nan 0 0\n", "Kd 0 0 1e999\n", "Kd 1 0\n",
                                  "Kd spectral file.rfl\n", "Kd 0,5 0,5 0,5\n"}) {
        EXPECT_EQ(colour_of(statement), grey) << statement;
        EXPECT_EQ(lines(warnings), 1u) << warnings;
        EXPECT_NE(warnings.find("m.mtl: line 2: 'Kd"), std::string::npos) << warnings;
    }
}

TEST_F(SceneMaterials, AreOfOneColourInsteadOfAMissingPicture)
{
    for (const char* statements : {"Kd 0 0 0\nmap_Kd brick.png\n", "map_Kd brick.png\nKd 0 0 0\n",
                                   "map_Kd -s 1 1 1 brick.png\n"}) {
        EXPECT_EQ(colour_of(statements), grey) << statements;
        EXPECT_EQ(lines(warnings), 1u) << warnings;
        EXPECT_NE(warnings.find("no such picture, one colour takes its place"), std::string::npos);
    }
    EXPECT_EQ(colour_of("map_Kd brick.png\nKd 0.75 0.25 0.125\n"), red);
    EXPECT_EQ(colour_of("map_Kd .\nmap_Kd /dev/zero\nKd 0.75 0.25 0.125\n"), red);
    EXPECT_NE(warnings.find("(and 1 more)"), std::string::npos) << warnings;
}

TEST_F(SceneMaterials, FindTheirPictures)
{
    const std::string with_uvs = square + "vt 0.5 0.25\nusemtl brick\n";
    write("Two Words #1.png", "");
    write("parts/brick.png", "");
    for (const char* name :
         {"Two Words #1.png", "two words #1.PNG  ", "parts/brick.png", "Parts\\Brick.png",
          "-s 2 4 1 -o 1 1 -clamp on -mm 0 1 parts/brick.png", "C:\\art\\two words #1.png",
          "-bm 2 -S 2 parts/brick.png", "parts/brick.png # red"}) {
        write("m.mtl", "newmtl brick\nKd 0.75 0.25 0.125\nmap_Kd " + std::string(name) + "\n");
        const Scene scene = load("mtllib m.mtl\n" + with_uvs + "f 1/1 2/1 3/1\nf 1 3 4\n");
        EXPECT_EQ(warnings, "") << name;
        ASSERT_EQ(scene.submeshes.size(), 2u) << "without texture coordinates there is no picture";
        EXPECT_TRUE(scene.submeshes[0].material.picture.empty());
        EXPECT_TRUE(std::filesystem::exists(scene.submeshes[1].material.picture)) << name;
        EXPECT_EQ(scene.corner(3).colour, red) << "it multiplies the picture";
        if (name[0] == '-' && name[1] == 's') {
            EXPECT_EQ(scene.corner(3).uv, glm::vec2(2, 2));
        } else if (name[0] != '-') {
            EXPECT_EQ(scene.corner(3).uv, glm::vec2(0.5f, 0.25f));
        }
    }
    write("m.mtl", "newmtl brick\nKd 0 0 0\nmap_Kd parts/brick.png\nmap_d parts/brick.png\n");
    const Scene black = load("mtllib m.mtl\n" + with_uvs + "f 1/1 2/1 3/1\n");
    EXPECT_EQ(black.corner(0).colour, vec3(1)) << "or the picture would not be seen";
    EXPECT_EQ(black.submeshes[0].material.mask, folder / "parts/brick.png");
}

TEST_F(SceneMaterials, AreClampedToWhatCanBeDrawn)
{
    EXPECT_EQ(colour_of("Kd -1 1e39 0.5\n"), vec3(0, 1, 0.5f));
    EXPECT_NE(warnings.find("line 2: 'Kd -1 1e39 0.5': outside 0 to 1"), std::string::npos);
    colour_of("Kd 0 0 0\nKe 1e39 -1 0.5\n");
    EXPECT_NE(warnings.find("line 3: 'Ke 1e39 -1 0.5': outside 0 to 1000"), std::string::npos);
    EXPECT_EQ(load_file(folder / "scene.obj").submeshes[0].material.light, vec3(1000, 0, 0.5f));
}

TEST_F(SceneMaterials, TellWhatShines)
{
    write("m.mtl", "newmtl stone\nKd 0.1 0.2 0.3\nnewmtl glass\nKd 1 1 1\nKe 1 0.5 0.25\n");
    const Scene scene = load("mtllib m.mtl\n" + square +
                             "v 0 1 0\nv 1 1 0\nv 0 2 0\n"
                             "usemtl stone\nf 1 2 3 4\nusemtl glass\nf 5 6 7\n");
    ASSERT_EQ(scene.indices.size(), 9u);
    ASSERT_EQ(scene.submeshes.size(), 2u);
    EXPECT_EQ(scene.submeshes[0].material.light, vec3(0));
    EXPECT_EQ(scene.submeshes[1].first, 6u);
    EXPECT_EQ(scene.submeshes[1].count, 3u);
    EXPECT_EQ(scene.submeshes[1].material.light, vec3(1, 0.5f, 0.25f));
    EXPECT_EQ(scene.corner(6).colour, vec3(1));  // by day it looks like any other
}

TEST_F(SceneMaterials, AreToldInShortAndOnOneLine)
{
    colour("", "usemtl " + std::string(1000, 'x') + "\x1b[31m\n");
    EXPECT_LT(warnings.size(), 250u);
    colour("", "usemtl \x1b[31mred\x07\n");
    EXPECT_NE(warnings.find("'usemtl ?[31mred?'"), std::string::npos) << warnings;
}
