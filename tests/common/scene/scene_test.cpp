// OBJ files of all kinds; test_collision.py has those that a program must refuse.
#include "common/scene/scene.hpp"

#include <gtest/gtest.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>
#include <iterator>
#include <sstream>

namespace fs = std::filesystem;
using glm::vec3;

namespace {

class SceneFile : public testing::Test {
protected:
    void SetUp() override
    {
        folder = fs::path(testing::TempDir()) / ("snowfall_scene_" + std::to_string(getpid()));
        fs::create_directories(folder);
    }
    void TearDown() override { fs::remove_all(folder); }

    Scene load(const std::string& text, char up = 'y')
    {
        std::ofstream(folder / "scene.obj", std::ios::binary) << text;
        return load_scene(folder / "scene.obj", up);
    }
    fs::path folder;
};

// m2, and as seen from above
double area(const Scene& scene, bool seen_from_above = false)
{
    double sum = 0;
    for (size_t i = 0; i < scene.vertices.size(); i += 3) {
        const vec3 a = scene.vertices[i].position;
        const vec3 across =
            glm::cross(scene.vertices[i + 1].position - a, scene.vertices[i + 2].position - a);
        sum += 0.5 * (seen_from_above ? across.y : glm::length(across));
    }
    return sum;
}

// 16 m wide, as wide as the world allows: it is not scaled.
const std::string square = "v -8 0 -8\nv -8 0 8\nv 8 0 8\nv 8 0 -8\n";

}  // namespace

TEST_F(SceneFile, WithPolygonsIsDividedIntoTriangles)
{
    EXPECT_EQ(load(square + "f 1 2 3 4\n").vertices.size(), 6u);
    // Six corners around a square, in a regular order.
    EXPECT_NEAR(area(load(square + "v -8 0 0\nv 8 0 0\nf 1 5 2 3 6 4\n")), 256, 1e-3);
}

TEST_F(SceneFile, MayHavePolygonsWithCornersThatPointInwards)
{
    // An L, from each of its corners on, facing up and facing down, lying and standing.
    const std::string corners[] = {
        "v -8 0 -8\nv -8 0 8\nv 8 0 8\nv 8 0 4\nv -4 0 4\nv -4 0 -8\n",
        "v 0 -8 0\nv 16 -8 0\nv 16 8 0\nv 12 8 0\nv 12 -4 0\nv 0 -4 0\n"};
    for (int first = 0; first < 6; ++first) {
        std::string face, reversed;
        for (int i = 0; i < 6; ++i) {
            const std::string corner = std::to_string((first + i) % 6 + 1) + " ";
            face += corner;
            reversed = corner + reversed;
        }
        const Scene scene = load(corners[0] + "f " + face + "\n");
        EXPECT_EQ(scene.vertices.size(), 3u * 4u);
        EXPECT_NEAR(area(scene), 16 * 4 + 12 * 4, 1e-3);
        EXPECT_NEAR(area(scene, true), 16 * 4 + 12 * 4, 1e-3) << "none is turned over";
        for (size_t i = 0; i < scene.vertices.size(); i += 3) {
            const vec3 middle = (scene.vertices[i].position + scene.vertices[i + 1].position +
                                 scene.vertices[i + 2].position) /
                                3.0f;
            EXPECT_TRUE(middle.x < -4 || middle.z > 4) << "outside the L";
        }
        EXPECT_NEAR(area(load(corners[0] + "f " + reversed + "\n"), true), -112, 1e-3);
        // Standing, it is scaled to a height of 6 m.
        EXPECT_NEAR(area(load(corners[1] + "f " + face + "\n")), 112 * 0.375 * 0.375, 1e-3);
    }
}

TEST_F(SceneFile, MayHaveACombOfManyTeeth)
{
    std::ostringstream text;  // 16 m wide; every second tooth's gap goes back to z = -7
    int corners = 0;
    const auto corner = [&](float x, float z) {
        text << "v " << x << " 0 " << z << "\n";
        ++corners;
    };
    for (int tooth = 0; tooth < 60; ++tooth) {
        const float x = 8 - float(tooth) * 16 / 60, width = 8.0f / 60;
        corner(x, -8), corner(x - width, -8);
        corner(x - width, 7), corner(x - 2 * width, 7);
    }
    corner(-8, 8), corner(8, 8);
    text << "f";
    for (int i = 1; i <= corners; ++i) text << " " << i;
    const Scene scene = load(text.str() + "\n");
    EXPECT_EQ(scene.vertices.size(), 3u * size_t(corners - 2));
    EXPECT_NEAR(area(scene), 16 + 8 * 15, 1e-3);
    EXPECT_NEAR(std::abs(area(scene, true)), 16 + 8 * 15, 1e-3);
}

TEST_F(SceneFile, MayHavePolygonsThatNoTrianglesCouldFill)
{
    // All corners in a line, all but one in one place, a bow tie, a spike, a hole with a seam to
    // it.
    for (const char* face : {"1 5 4 5 1 4", "1 1 1 1 1 2", "1 2 4 3", "1 2 3 2 4"}) {
        std::istringstream words(face);
        const auto corners = std::distance(std::istream_iterator<int>(words), {});
        const Scene scene = load(square + "v 0 0 -8\nf 1 2 3\nf " + std::string(face) + "\n");
        EXPECT_EQ(scene.vertices.size(), size_t(3 * (1 + corners - 2))) << face;
    }
    const Scene ring = load(square + "v -4 0 -4\nv -4 0 4\nv 4 0 4\nv 4 0 -4\n"
                                     "f 1 2 3 4 1 5 8 7 6 5\n");
    EXPECT_NEAR(area(ring), 16 * 16 - 8 * 8, 1e-3);
    EXPECT_NEAR(area(ring, true), 16 * 16 - 8 * 8, 1e-3);
}

TEST_F(SceneFile, MayHavePolygonsThatAreNotFlat)
{
    const Scene scene = load("v -8 0 -8\nv -8 1 8\nv 8 0 8\nv 8 1 -8\nf 1 2 3 4\n");
    EXPECT_EQ(scene.vertices.size(), 6u);
    EXPECT_NEAR(area(scene, true), 256, 1e-3);
}

TEST_F(SceneFile, RefusesPolygonsWithMoreCornersThanCanBeCounted)
{
    std::string face = "f";
    for (int i = 0; i < 256; ++i) face.append(" ").append(std::to_string(i % 4 + 1));
    try {
        load(square + face + "\n");
        FAIL();
    } catch (const std::runtime_error& error) {
        EXPECT_NE(std::string(error.what()).find("line 5: 256 corners"), std::string::npos);
    }
}

TEST_F(SceneFile, MayCountItsVerticesBackwards)
{
    EXPECT_NEAR(area(load(square + "f -4 -3 -2 -1\n"), true), 256, 1e-3);
}

TEST_F(SceneFile, MayHaveTextureCoordinatesAndNormalsOrNot)
{
    const std::string more = "vt 0 0\nvn 0 1 0\n";
    for (const char* face : {"f 1 2 3 4\n", "f 1/1 2/1 3/1 4/1\n", "f 1//1 2//1 3//1 4//1\n",
                             "f 1/1/1 2/1/1 3/1/1 4/1/1\n"}) {
        const Scene scene = load(square + more + face);
        EXPECT_NEAR(area(scene), 256, 1e-3) << face;
        EXPECT_EQ(scene.vertices.front().normal, vec3(0, 1, 0)) << face;
    }
}

TEST_F(SceneFile, MayHaveWindowsLineEndsCommentsAndOddSpaces)
{
    const Scene scene = load("# a comment\r\nv  -8 0 -8\r\nv -8\t0 8 \r\nv 8 0 8 1.0\r\n\r\n"
                             "v 8 0 -8\r\ns off\r\nf 1 2 3 4 \r\n");
    EXPECT_NEAR(area(scene), 256, 1e-3);
}

TEST_F(SceneFile, WithoutLineEndAtTheEndIsWhole)
{
    EXPECT_NEAR(area(load(square + "f 1 2 3 4")), 256, 1e-3);
}

TEST_F(SceneFile, MayHoldSeveralObjectsAndGroups)
{
    const Scene scene = load(square + "o one\nf 1 2 3\no two\ng part\nf 1 3 4\n");
    EXPECT_NEAR(area(scene), 256, 1e-3);
}

TEST_F(SceneFile, TakesItsColoursFromTheMaterialsBesideIt)
{
    std::ofstream(folder / "scene.mtl") << "newmtl red\nKd 0.75 0.25 0.125\n";
    const Scene scene =
        load("mtllib scene.mtl\n" + square + "usemtl red\nf 1 2 3\nusemtl none\nf 1 3 4\n");
    EXPECT_EQ(scene.vertices[0].colour, vec3(0.75f, 0.25f, 0.125f));
    EXPECT_EQ(scene.vertices[5].colour, vec3(0.5f));
}

TEST_F(SceneFile, TellsWhatShines)
{
    std::ofstream(folder / "m.mtl")
        << "newmtl stone\nKd 0.1 0.2 0.3\nnewmtl glass\nKd 1 1 1\nKe 1 0.5 0.25\n";
    const Scene scene = load("mtllib m.mtl\n" + square +
                             "v 0 1 0\nv 1 1 0\nv 0 2 0\n"
                             "usemtl stone\nf 1 2 3 4\nusemtl glass\nf 5 6 7\n");
    ASSERT_EQ(scene.vertices.size(), 9u);
    ASSERT_EQ(scene.lamps.size(), 3u);
    EXPECT_EQ(scene.lamps[0].position, vec3(0, 1, 0));
    EXPECT_EQ(scene.lamps[0].colour, vec3(1, 0.5f, 0.25f));
    EXPECT_EQ(scene.vertices[6].colour, vec3(1));  // by day it looks like any other
}

TEST_F(SceneFile, IsGreyIfItsMaterialsAreMissing)
{
    const Scene scene = load("mtllib none.mtl\n" + square + "usemtl red\nf 1 2 3 4\n");
    EXPECT_EQ(scene.vertices[0].colour, vec3(0.5f));
}

TEST_F(SceneFile, IsFittedIntoTheWorldWithItsFloorOnTheGround)
{
    const Scene scene =
        load("v 100 50 0\nv 100 50 400\nv 500 50 400\nv 300 60 200\nf 1 2 3\nf 1 3 4\n");
    vec3 least = scene.vertices[0].position, most = least;
    for (const Vertex& vertex : scene.vertices) {
        least = glm::min(least, vertex.position);
        most = glm::max(most, vertex.position);
    }
    const float micrometre = 1e-6f;  // as finely as a float tells points 8 m away apart
    EXPECT_LE(glm::distance(least, vec3(-8, 0, -8)), micrometre);
    EXPECT_LE(glm::distance(most, vec3(8, 0.4f, 8)), micrometre);
}

TEST_F(SceneFile, MayHaveZUp)
{
    const Scene scene = load("v -8 -8 0\nv 8 -8 0\nv 8 8 0\nv 0 0 4\nf 1 2 3\nf 1 2 4\n", 'z');
    float highest = 0;
    for (const Vertex& vertex : scene.vertices) highest = std::max(highest, vertex.position.y);
    EXPECT_EQ(highest, 4);
    EXPECT_EQ(scene.vertices[0].normal, vec3(0, 1, 0)) << "turned, not mirrored";
}

TEST_F(SceneFile, NoneIsTheEmptyScene)
{
    EXPECT_TRUE(load_scene("none", 'y').vertices.empty());
}
