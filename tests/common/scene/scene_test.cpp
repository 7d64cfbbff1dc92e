// OBJ files of all kinds; test_collision.py has those that a program must refuse.
#include "common/scene/scene.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <sstream>
#include <string>

#include "tests/common/scene/scene_file.hpp"

using glm::vec3;

TEST_F(SceneFile, WithPolygonsIsDividedIntoTriangles)
{
    EXPECT_EQ(load(square + "f 1 2 3 4\n").indices.size(), 6u);
    // Six corners around a square, in a regular order.
    EXPECT_NEAR(area(load(square + "v -8 0 0\nv 8 0 0\nf 1 5 2 3 6 4\n")), 256, 1e-3);
}

TEST_F(SceneFile, MayHavePolygonsWithCornersThatPointInwards)
{
    // An L, from each of its corners on, run either way around, lying and standing.
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
        EXPECT_EQ(scene.indices.size(), 3u * 4u);
        EXPECT_NEAR(area(scene), 16 * 4 + 12 * 4, 1e-3);
        EXPECT_NEAR(area(scene, true), 16 * 4 + 12 * 4, 1e-3) << "none is turned over";
        for (size_t i = 0; i < scene.indices.size(); i += 3) {
            const vec3 middle = (scene.corner(i).position + scene.corner(i + 1).position +
                                 scene.corner(i + 2).position) /
                                3.0f;
            EXPECT_TRUE(middle.x < -4 || middle.z > 4) << "outside the L";
        }
        EXPECT_NEAR(area(load(corners[0] + "f " + reversed + "\n"), true), 112, 1e-3);
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
    EXPECT_EQ(scene.indices.size(), 3u * size_t(corners - 2));
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
        EXPECT_EQ(scene.indices.size(), size_t(3 * (1 + corners - 2))) << face;
    }
    const Scene ring = load(square + "v -4 0 -4\nv -4 0 4\nv 4 0 4\nv 4 0 -4\n"
                                     "f 1 2 3 4 1 5 8 7 6 5\n");
    EXPECT_NEAR(area(ring), 16 * 16 - 8 * 8, 1e-3);
    EXPECT_NEAR(area(ring, true), 16 * 16 - 8 * 8, 1e-3);
}

TEST_F(SceneFile, MayHavePolygonsThatAreNotFlat)
{
    const Scene scene = load("v -8 0 -8\nv -8 1 8\nv 8 0 8\nv 8 1 -8\nf 1 2 3 4\n");
    EXPECT_EQ(scene.indices.size(), 6u);
    EXPECT_NEAR(area(scene, true), 256, 1e-3);
}

// A face of many corners around the y axis, 16 m wide; every second one at `inner` of the radius.
static std::string star(int corners, double inner)
{
    std::ostringstream text;
    for (int i = 0; i < corners; ++i) {
        const double angle = 2 * M_PI * i / corners, radius = i % 2 ? 8 * inner : 8;
        text << "v " << radius * std::cos(angle) << " 0 " << radius * std::sin(angle) << "\n";
    }
    text << "f";
    for (int i = corners; i > 0; --i) text << " " << i;
    return text.str() + "\n";
}

TEST_F(SceneFile, MayHavePolygonsOfManyCorners)
{
    for (const int corners : {256, 1000, 5000}) {
        const Scene disc = load(star(corners, 1));
        EXPECT_EQ(disc.indices.size(), 3u * size_t(corners - 2));
        EXPECT_NEAR(area(disc, true), M_PI * 64, 0.1);
        EXPECT_NEAR(area(disc), area(disc, true), 0.01);
        const Scene spiky = load(star(corners, 0.5));
        EXPECT_NEAR(area(spiky, true), M_PI * 32, 0.1);
        EXPECT_NEAR(area(spiky), area(spiky, true), 0.01);
    }
    EXPECT_NE(refusal(star(10001, 1)).find("line 10002: 10001 corners"), std::string::npos);
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

TEST_F(SceneFile, MayLeaveTextureCoordinatesAndNormalsEmpty)
{
    for (const char* face : {"f 1// 2// 3// 4//\n", "f 1/ 2/ 3/ 4/\n", "f 1/1/ 2/2/ 3/3/ 4/4/\n",
                             "f 1/9/9 2/9/9 3/9/9 4/9/9\n"}) {
        EXPECT_NEAR(area(load(square + face)), 256, 1e-3) << face;
    }
}

TEST_F(SceneFile, MayHaveOddLineEndsCommentsAndSpaces)
{
    const std::string text = "# a comment\nv  -8 0 -8\nv -8\t0 8 \nv 8 0 8 1.0 # a corner\n\n"
                             "v 8 0 -8\t#another\ns off\nf 1 2 3 4 \\\n   # the floor\n"
                             "# a backslash at the end of this goes nowhere: C:\\\n"
                             "\t v 0 6 \\\n 0#\nf 1 2 \\\n5\n";
    for (const std::string line_end : {"\n", "\r\n", "\r"}) {
        std::string ended, marked = "\xEF\xBB\xBF";
        for (const char c : text) ended += c == '\n' ? line_end : std::string(1, c);
        const double expected = 256 + 0.5 * 16 * 10;
        EXPECT_NEAR(area(load(ended)), expected, 1e-3);
        EXPECT_NEAR(area(load(marked + ended)), expected, 1e-3);
        // The number of the line is still that of the file.
        EXPECT_NE(refusal(marked + ended + "f 1 2" + line_end).find("line 15: 2 corners"),
                  std::string::npos)
            << refusal(ended + "f 1 2" + line_end);
    }
}

TEST_F(SceneFile, DoesNotLoseAVertexToAByteOrderMark)
{
    EXPECT_NEAR(area(load("\xEF\xBB\xBF" + square + "v 0 6 0\nf 1 2 3\nf 1 3 4\n"), true), 256,
                1e-3);
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

TEST_F(SceneFile, MayHaveColoursAtItsVertices)
{
    const std::string coloured = "v -8 0 -8 1 0 0\nv -8 0 8 0 1 0\nv 8 0 8 0 0.5 7\nf 1 2 3\n";
    for (const Vertex& vertex : load(coloured).vertices) {
        if (vertex.position.z < 0)
            EXPECT_EQ(vertex.colour, vec3(1, 0, 0));
        else if (vertex.position.x < 0)
            EXPECT_EQ(vertex.colour, vec3(0, 1, 0));
        else
            EXPECT_EQ(vertex.colour, vec3(0, 0.5f, 1)) << "no more than 1";
    }
    write("m.mtl", "newmtl red\nKd 0.5 0 0\n");
    EXPECT_EQ(load("mtllib m.mtl\nusemtl red\n" + coloured).corner(1).colour, vec3(0.5f, 0, 0));
}

TEST_F(SceneFile, IsFittedIntoTheWorldWithItsFloorOnTheGround)
{
    const Scene scene =
        load("v 100 50 0\nv 100 50 400\nv 500 50 400\nv 300 60 200\nf 1 2 3\nf 1 3 4\n");
    vec3 least = scene.corner(0).position, most = least;
    for (const Vertex& vertex : scene.vertices) {
        least = glm::min(least, vertex.position);
        most = glm::max(most, vertex.position);
    }
    const float micrometre = 1e-6f;  // as finely as a float tells points 8 m away apart
    EXPECT_LE(glm::distance(least, vec3(-8, 0, -8)), micrometre);
    EXPECT_LE(glm::distance(most, vec3(8, 0.4f, 8)), micrometre);
}

// A stair of 5 steps at this place, in metres.
static std::string stair(double x, double y, double z)
{
    std::ostringstream text;
    text.precision(12);
    for (int step = 0; step < 5; ++step) {
        const double left = x + 0.4 * step, height = y + 0.3 * step;
        for (const double across : {left, left + 0.4})
            text << "v " << across << " " << height << " " << z << "\n"
                 << "v " << across << " " << height << " " << z + 6 << "\n";
        text << "f -4 -3 -1 -2\n";
    }
    return text.str();
}

TEST_F(SceneFile, KeepsItsShapeFarFromItsOrigin)
{
    const Scene near = load(stair(0, 0, 0)), far = load(stair(691500, 300, 5336200));
    ASSERT_EQ(near.indices.size(), far.indices.size());
    for (size_t i = 0; i < near.indices.size(); ++i) {
        EXPECT_LE(glm::distance(near.corner(i).position, far.corner(i).position), 1e-5f);
    }
}

TEST_F(SceneFile, IsRefusedIfItIsNoSizeAtAll)
{
    const auto triangle = [](const std::string& size) {
        return "v 0 0 -" + size + "\nv 0 0 " + size + "\nv " + size + " 0 0\nf 1 2 3\n";
    };
    for (const char* size : {"3e38", "1e-38", "1e-45", "1e308", "1e35", "1e-35"})
        EXPECT_NE(refusal(triangle(size)).find("scene.obj: it is"), std::string::npos) << size;
    for (const char* size : {"1e-12", "0.001", "1e6", "1e+12"})
        EXPECT_NEAR(area(load(triangle(size))), 64, 1e-3) << size;
    for (const char* size : {"1e309", "nan", "inf", "0x10", "1,5", "1e", "-", "1.5m"}) {
        const std::string line = "line 3: '" + std::string(size) + "' is no coordinate";
        EXPECT_NE(
            refusal("v 0 0 0\nv 1 1 1\nv 0 " + std::string(size) + " 0\nf 1 2 3\n").find(line),
            std::string::npos)
            << size;
    }
}

TEST_F(SceneFile, MayNameVerticesThatFollow)
{
    EXPECT_NEAR(area(load("f 1 2 3 4\n" + square)), 256, 1e-3);
}

TEST_F(SceneFile, IsRefusedWithTheLineOfABadCorner)
{
    for (const char* corner :
         {"0", "5", "-5", "x", "1x", "1/x", "1.5", "99999999999", "99999999999999999999",
          "-99999999999999999999", "/1", "4294967297"}) {
        const std::string reason = refusal(square + "f 1 2 " + corner + "\n");
        EXPECT_NE(reason.find("scene.obj: line 5: "), std::string::npos) << corner << reason;
    }
}

TEST_F(SceneFile, MayHaveZUp)
{
    const Scene scene = load("v -8 -8 0\nv 8 -8 0\nv 8 8 0\nv 0 0 4\nf 1 2 3\nf 1 2 4\n", 'z');
    float highest = 0;
    for (const Vertex& vertex : scene.vertices) highest = std::max(highest, vertex.position.y);
    EXPECT_EQ(highest, 4);
    EXPECT_EQ(scene.corner(0).normal, vec3(0, 1, 0)) << "turned, not mirrored";
}

TEST_F(SceneFile, NoneIsTheEmptyScene)
{
    EXPECT_TRUE(load_scene("none", 'y').vertices.empty());
}
