// OBJ files of all kinds, and what is told or refused where one is at fault.
#include "common/scene/scene.hpp"

#include <gtest/gtest.h>
#include <unistd.h>

#include <cmath>
#include <fstream>
#include <iostream>
#include <random>
#include <sstream>

using glm::vec2;
using glm::vec3;

namespace {

// 16 m wide, as wide as the world allows: it is not scaled.
const std::string square = "v -8 0 -8\nv -8 0 8\nv 8 0 8\nv 8 0 -8\n";

class SceneFile : public testing::Test {
protected:
    void SetUp() override
    {
        folder = std::filesystem::path(testing::TempDir()) / ("scene_" + std::to_string(getpid()));
        std::filesystem::create_directories(folder);
    }
    void TearDown() override { std::filesystem::remove_all(folder); }

    void write(const std::string& name, const std::string& text) const
    {
        std::ofstream(folder / name, std::ios::binary) << text;
    }

    // What is said on stderr is left in `warnings`.
    Scene load(const std::string& text, char up = 'y')
    {
        write("scene.obj", text);
        std::ostringstream said;
        std::streambuf *const err = std::cerr.rdbuf(said.rdbuf()), *const out = std::cout.rdbuf();
        std::cout.rdbuf(nullptr);
        const auto restore = [&](void*) {
            std::cerr.rdbuf(err);
            std::cout.rdbuf(out);
            warnings = said.str();
        };
        const std::unique_ptr<void, decltype(restore)> at_end(this, restore);
        return load_scene(folder / "scene.obj", up);
    }

    // Empty if the scene is not refused.
    std::string refusal(const std::string& text)
    try {
        load(text);
        return "";
    } catch (const std::runtime_error& error) {
        return error.what();
    }

    // The material of a square with this in its MTL file, the colour of its first corner in it.
    Material material(const std::string& mtl, const std::string& name = "brick")
    {
        write("two words.mtl", "newmtl " + name + "\n" + mtl);
        const Scene scene = load("mtllib two words.mtl\n" + square + "vt 0.5 0.25\nusemtl " + name +
                                 "\nf 1/1 2/1 3/1 4/1\n");
        Material result = scene.submeshes.at(0).material;
        result.colour = scene.corner(0).colour;
        result.uv_offset = scene.corner(0).uv;
        return result;
    }

    std::filesystem::path folder;
    std::string warnings;
};

// m2, and as seen from above
double area(const Scene& scene, bool seen_from_above = false)
{
    double sum = 0;
    for (size_t i = 0; i < scene.indices.size(); i += 3) {
        const vec3 a = scene.corner(i).position;
        const vec3 across =
            glm::cross(scene.corner(i + 1).position - a, scene.corner(i + 2).position - a);
        sum += 0.5 * (seen_from_above ? across.y : glm::length(across));
    }
    return sum;
}

// The same faces the other way around.
std::string over(const std::string& text)
{
    std::istringstream lines(text);
    std::string result;
    for (std::string line; std::getline(lines, line);) {
        std::istringstream words(line.substr(1));
        std::string reversed;
        for (std::string word; words >> word;) reversed = " " + word + reversed;
        result += (line[0] == 'f' ? "f" + reversed : line) + "\n";
    }
    return result;
}

}  // namespace

TEST_F(SceneFile, IsFittedIntoTheWorldWithItsFloorOnTheGround)
{
    const Scene scene =
        load("v 100 50 0\nv 100 50 400\nv 500 50 400\nv 300 60 200\nf 1 2 3\nf 1 3 4\n");
    vec3 least(INFINITY), most(-INFINITY);
    for (const Vertex& vertex : scene.vertices) {
        least = glm::min(least, vertex.position);
        most = glm::max(most, vertex.position);
    }
    EXPECT_LE(glm::distance(least, vec3(-8, 0, -8)), 1e-6f);
    EXPECT_LE(glm::distance(most, vec3(8, 0.4f, 8)), 1e-6f);
    EXPECT_TRUE(load_scene("none", 'y').vertices.empty());
}

TEST_F(SceneFile, KeepsItsShapeFarFromItsOrigin)
{
    const Scene scene = load("v 691500.1 300 5336200\nv 691500.5 300.3 5336200\n"
                             "v 691500.5 300.3 5336206\nv 691500.1 300 5336206\nf 1 2 3 4\n");
    const float scale = 16 / 6.0f;  // to the width of the world
    for (const Vertex& vertex : scene.vertices) {
        EXPECT_NEAR(std::abs(vertex.position.x), 0.2f * scale, 1e-5f);
        EXPECT_NEAR(std::abs(vertex.position.y - 0.15f * scale), 0.15f * scale, 1e-5f);
    }
}

TEST_F(SceneFile, MayHaveZUp)
{
    const Scene scene =
        load("v -8 -8 0\nv 8 -8 0\nv 8 8 0\nv 0 0 4\nvn 0 0 1\nf 1//1 2//1 3//1\nf 1 2 4\n", 'z');
    float highest = 0;
    for (const Vertex& vertex : scene.vertices) highest = std::max(highest, vertex.position.y);
    EXPECT_EQ(highest, 4);
    EXPECT_EQ(scene.corner(0).normal, vec3(0, 1, 0)) << "turned, not mirrored";
}

TEST_F(SceneFile, MayHavePolygonsWithCornersThatPointInwards)
{
    // An L, from each of its corners on and either way around, far from its origin.
    const std::string corners =
        "v 92 0 92\nv 92 0 108\nv 108 0 108\nv 108 0 104\nv 96 0 104\nv 96 0 92\n";
    for (int first = 0; first < 6; ++first) {
        std::string face = "f";
        for (int i = 0; i < 6; ++i) face += ' ' + std::to_string((first + i) % 6 + 1);
        for (const std::string& text : {corners + face, over(corners + face)}) {
            EXPECT_NEAR(area(load(text)), 16 * 4 + 12 * 4, 1e-3);
            EXPECT_NEAR(area(load(text), true), 16 * 4 + 12 * 4, 1e-3) << "none is turned over";
        }
    }
}

TEST_F(SceneFile, MayBeWrittenInManyWays)
{
    const std::string normal = "vt 0 0\nvn 0 1 0\n", face = "f 1 2 3 4";
    for (const std::string& text :
         {square + face, "\xEF\xBB\xBF" + square + face + "\n", face + "\n" + square,
          square + "f -4 -3 -2 -1\n", square + "f 1 2 \\\n  3 \\\r\n 4 # the floor\n",
          "# C:\\\n" + square + face + std::string("\n\0\n", 3),
          square + "v 9 9 9 # a corner\n" + face,
          square + "o one\nf 1 2 3\no two\ng part\nf 1 3 4\n",
          square + normal + "f 1/1 2/1 3/1 4/1\n", square + normal + "f 1//1 2//1 3//1 4//1 \t\r\n",
          square + "f 1/9/9 2/9/9 3/9/9 4/9/9\n"}) {
        const Scene scene = load(text);
        EXPECT_NEAR(area(scene, true), 256, 1e-3) << text;
        EXPECT_EQ(scene.vertices.size(), 4u) << text;
        EXPECT_EQ(scene.corner(0).normal, vec3(0, 1, 0)) << text;
        EXPECT_EQ(warnings, "");
    }
}

TEST_F(SceneFile, IsRefusedWithTheReason)
{
    for (const auto& [text, reason] : std::vector<std::pair<std::string, std::string>>{
             {square + "f 1 2 0\n", "line 5"},
             {square + "f 1 2 \\\n3 \\\n4\nf 1 2 x\n", "line 8"},
             {square + "f 1 2 5\n", "vertex"},
             {"v 0 0 0\nv 0,5 0 0\nv 0 nan 0\n", "line 2 has no numbers: 0,5 0 0"},
             {"", "no faces"},
             {"v 1e999 0 0\nv 0 0 0\nv 0 1 0\nf 1 2 3\n", "one point"},
             {"v 1 1 1\nv 1 1 1\nv 1 1 1\nf 1 2 3\n", "one point"},
             {square + "f 1 2\n", "no faces: export it as polygons"},
             {square + "cstype bspline\nsurf 0 1 0 1 1 2 3 4\nend\n", "no faces"}}) {
        EXPECT_NE(refusal(text).find(reason), std::string::npos) << text << refusal(text);
        EXPECT_NE(refusal(text).find("scene.obj"), std::string::npos);
        EXPECT_EQ(refusal(text).find('\n'), std::string::npos);
    }
}

TEST_F(SceneFile, CarriesItsSnowOnTop)
{
    // Sheets: flat, leaning, a vault; each alone and over a floor that faces up.
    const std::string floor = "v -8 -1 -8\nv -8 -1 8\nv 8 -1 8\nv 8 -1 -8\nf -4 -3 -2 -1\n";
    for (const char* sheet : {"v -3 2 -3\nv -3 2 3\nv 3 2 3\nv 3 2 -3\nf -4 -3 -2 -1\n",
                              "v 0 0 -3\nv 0 0 3\nv 1 1.5 3\nv 1 1.5 -3\nf -4 -3 -2 -1\n",
                              "v -2 0 -3\nv -2 0 3\nv 0 1 3\nv 0 1 -3\nv 2 0 3\nv 2 0 -3\n"
                              "f -6 -5 -4 -3\nf -3 -4 -2 -1\n"}) {
        const double expected = area(load(floor + sheet), true);
        EXPECT_GT(expected, 256);
        EXPECT_NEAR(area(load(floor + over(sheet)), true), expected, 1e-3) << sheet;
        EXPECT_NEAR(area(load(over(floor + sheet)), true), expected, 1e-3) << sheet;
        EXPECT_NEAR(area(load(floor + sheet + over(sheet)), true), 256, 1e-3) << "both sides";
    }
}

TEST_F(SceneFile, SharesCornersThatAreTheSame)
{
    const std::string roof = "v -8 0 -8\nv -8 0 8\nv 0 6 8\nv 0 6 -8\nv 8 0 8\nv 8 0 -8\n";
    const std::string up = "vn 0 3 0\nvn 0 0 0\nvn 0 -1 0\n";  // of any length, of none, downwards
    for (const auto& [slopes, vertices] : std::vector<std::pair<std::string, size_t>>{
             {"f 1 2 3 4\nf 4 3 5 6\n", 8},  // flat: two normals meet at the ridge
             {"s 1\nf 1 2 3 4\nf 4 3 5 6\n", 6},
             {"s 1\nf 1 2 3 4\ns 2\nf 4 3 5 6\n", 8},
             {"s 1\ns off\nf 1 2 3 4\nf 4 3 5 6\n", 8},
             {up + "f 1//1 2//1 3//1 4//1\nf 4//1 3//1 5//1 6//1\n", 6},
             {up + "f 1//2 2//2 3//2 4//2\nf 4//2 3//2 5//2 6//2\n", 8}}) {
        const Scene scene = load(roof + slopes);
        EXPECT_EQ(scene.vertices.size(), vertices) << slopes;
        for (const Vertex& vertex : scene.vertices) {
            EXPECT_NEAR(glm::length(vertex.normal), 1, 1e-6);
            EXPECT_GT(vertex.normal.y, 0.5f);
        }
    }
}

TEST_F(SceneFile, HasASubmeshForEachMaterial)
{
    write("m.mtl", "newmtl a\nKd 1 0 0\nnewmtl b\nKd 0 1 0\nKe 1 0.5 0.25\n");
    const Scene scene = load("mtllib m.mtl\n" + square +
                             "usemtl b\nf 1 2 3\nusemtl a\nf 1 3 4\nusemtl b\nv 0 4 0\nf 1 2 5\n");
    ASSERT_EQ(scene.submeshes.size(), 2u) << "however often the file changes between them";
    EXPECT_EQ(scene.submeshes[0].count, 3u);
    EXPECT_EQ(scene.submeshes[1].first, 3u);
    EXPECT_EQ(scene.submeshes[1].count, 6u);
    EXPECT_EQ(scene.submeshes[1].material.light, vec3(1, 0.5f, 0.25f));
    EXPECT_EQ(scene.corner(0).colour, vec3(1, 0, 0));
    EXPECT_EQ(scene.corner(8).colour, vec3(0, 1, 0));
}

TEST_F(SceneFile, HasTheColoursOfItsMaterials)
{
    EXPECT_EQ(material("Kd 0.75 0.25 0.125\r\n", "red  brick #1").colour,
              vec3(0.75f, 0.25f, 0.125f));
    EXPECT_EQ(material("Kd 2 -1 0.5\nKe 1e39 -1 0.5\n").colour, vec3(1, 0, 0.5f));
    EXPECT_EQ(material("Kd 2 -1 0.5\nKe 1e39 -1 0.5\n").light, vec3(1000, 0, 0.5f));
    const Material pictured =
        material("Kd 0 0 0\nmap_Kd -s 2 4 1 -o 1 1 0 parts\\a b.png\nmap_d m.png\n");
    EXPECT_EQ(pictured.colour, vec3(1)) << "or the picture would not be seen";
    EXPECT_EQ(pictured.picture, folder / "parts/a b.png");
    EXPECT_EQ(pictured.mask, folder / "m.png");
    EXPECT_EQ(pictured.uv_offset, vec2(2, 2));
    EXPECT_EQ(warnings, "");
}

TEST_F(SceneFile, TellsWhichMaterialsAreMissing)
{
    write("m.mtl", "newmtl brick\nKd 1 0 0\n");
    const std::string two = square + "usemtl wood\nf 1 2 3\nusemtl iron\nf 1 3 4\n";
    for (const auto& [text, words] : std::vector<std::pair<std::string, std::string>>{
             {"mtllib m.mtl\n" + two, "'wood'"},
             {"usemtl brick\nmtllib m.mtl\n" + square + "f 1 2 3\n", "'brick'"},
             {"mtllib m.mtl\n" + square + "f 1 2 3\n", "none of its materials"},
             {"mtllib n.mtl\n" + two, "no " + (folder / "n.mtl").string()}}) {
        EXPECT_EQ(load(text).corner(0).colour, vec3(0.5f));
        EXPECT_NE(warnings.find(words), std::string::npos) << warnings;
        EXPECT_LE(std::count(warnings.begin(), warnings.end(), '\n'), 2) << warnings;
    }
}

// Whatever is in a file, it is read as a scene that can be drawn, or refused in a line.
TEST_F(SceneFile, MayBeSpoiltAtRandom)
{
    const std::string good = "mtllib m.mtl\n" + square +
                             "vt 0 0\nvt 1 0.5\nvn 0 1 0\ns 1\nusemtl a\n"
                             "f 1/1/1 2/2/1 3/-1/-1 4/1\nusemtl b\nv 0 1 0 1 0 1\nv 1 1e0 0\n"
                             "f -1//1 -2/2 -3 # a lamp\nf 1 5 2 \\\n6\n";
    const std::string pieces[] = {"vt ", "s ", "//", "v ", "f ",         "\n",  "\\\n",
                                  "#",   "/",  "-",  "9",  "4294967296", "nan", "usemtl "};
    write("m.mtl", "newmtl a\nKd 0.5 0.25 1\nmap_Kd -s 1 2 m.mtl\nnewmtl b\nKe 1 2 3\n");
    std::mt19937 random(1);
    for (int round = 0; round < 200; ++round) {
        std::string text = good;
        for (size_t changes = 1 + random() % 6; changes > 0; --changes) {
            const size_t at = random() % text.size();
            if (random() % 2)
                text.insert(at, pieces[random() % std::size(pieces)]);
            else
                text.replace(at, random() % 8, 1, char(random() % 256));
        }
        try {
            const Scene scene = load(text);
            EXPECT_EQ(scene.indices.size() % 3, 0u);
            for (const Vertex& vertex : scene.vertices) {
                EXPECT_LE(glm::length(vertex.position), 13) << text;
                EXPECT_NEAR(glm::length(vertex.normal), 1, 1e-3) << text;
                EXPECT_TRUE(std::isfinite(glm::dot(vertex.colour, vertex.colour))) << text;
            }
        } catch (const std::runtime_error& refusal) {
            EXPECT_EQ(std::string(refusal.what()).find('\n'), std::string::npos) << text;
        }
    }
}
