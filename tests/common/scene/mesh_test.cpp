// A scene as it is drawn: corners that are shared, normals, texture coordinates.
#include <set>

#include "common/harness/files.hpp"
#include "tests/common/scene/scene_file.hpp"

using glm::vec2;
using glm::vec3;

namespace {

// A roof: two slopes that meet in a ridge along z.
const std::string roof = "v -8 0 -8\nv -8 0 8\nv 0 6 8\nv 0 6 -8\nv 8 0 8\nv 8 0 -8\n";
const std::string slopes = "f 1 2 3 4\nf 4 3 5 6\n";

class SceneMeshOfAFile : public SceneFile {
protected:
    // The normals at the ridge, those that differ.
    size_t normals_at_ridge(const std::string& faces)
    {
        std::set<std::string> different;
        for (const Vertex& vertex : load(roof + faces).vertices) {
            EXPECT_NEAR(glm::length(vertex.normal), 1, 1e-6);
            if (vertex.position.y > 5) different.insert(std::to_string(vertex.normal.x));
        }
        return different.size();
    }
};

}  // namespace

TEST_F(SceneMeshOfAFile, SharesCornersThatAreTheSame)
{
    EXPECT_EQ(load(square + "f 1 2 3 4\n").vertices.size(), 4u);
    EXPECT_EQ(load(square + "f 1 2 3\nf 1 3 4\n").vertices.size(), 4u);
    // Along the ridge of a flat-shaded roof two normals meet, along that of a smooth one do not.
    EXPECT_EQ(load(roof + slopes).vertices.size(), 8u);
    EXPECT_EQ(load(roof + "s 1\n" + slopes).vertices.size(), 6u);
}

TEST_F(SceneMeshOfAFile, HasASubmeshForEachMaterial)
{
    write("m.mtl", "newmtl a\nKd 1 0 0\nnewmtl b\nKd 0 1 0\n");
    const Scene scene = load("mtllib m.mtl\n" + square +
                             "usemtl b\nf 1 2 3\nusemtl a\nf 1 3 4\nusemtl b\nv 0 4 0\nf 1 2 5\n");
    ASSERT_EQ(scene.submeshes.size(), 2u) << "however often the file changes between them";
    EXPECT_EQ(scene.submeshes[0].count, 3u);
    EXPECT_EQ(scene.submeshes[1].count, 6u);
    for (const Submesh& submesh : scene.submeshes) {
        for (size_t i = submesh.first; i < submesh.first + submesh.count; ++i)
            EXPECT_EQ(scene.corner(i).colour, submesh.material.colour);
    }
}

TEST_F(SceneMeshOfAFile, IsSmoothWithinASmoothingGroup)
{
    EXPECT_EQ(normals_at_ridge(slopes), 2u);
    EXPECT_EQ(normals_at_ridge("s 1\n" + slopes), 1u);
    EXPECT_EQ(normals_at_ridge("s on\n" + slopes), 1u);
    EXPECT_EQ(normals_at_ridge("s 1\nf 1 2 3 4\ns 2\nf 4 3 5 6\n"), 2u);
    EXPECT_EQ(normals_at_ridge("s 1\ns off\n" + slopes), 2u);
    EXPECT_EQ(normals_at_ridge("s 1\ns 0\n" + slopes), 2u);
    EXPECT_EQ(normals_at_ridge("s 1\nf 4 3 2 1\nf 4 3 5 6\n"), 1u) << "one is turned over";
}

TEST_F(SceneMeshOfAFile, HasTheNormalsOfItsFile)
{
    const std::string up = "vn 0 3 0\nvn 0 0 0\n";  // of any length; of none
    EXPECT_EQ(normals_at_ridge(up + "f 1//1 2//1 3//1 4//1\nf 4//1 3//1 5//1 6//1\n"), 1u);
    EXPECT_EQ(normals_at_ridge(up + "f 1//2 2//2 3//2 4//2\nf 4//2 3//2 5//2 6//2\n"), 2u);
    EXPECT_EQ(normals_at_ridge(up + "f 1//1 2//1 3//-2 4//-2\nf 4//9 3//9 5//9 6//9\n"), 2u);
    for (const Vertex& vertex :
         load(roof + up + "s 1\nf 1//1 2//1 3//1 4//1\nf 4//1 3//1 5//1 6//1\n").vertices)
        EXPECT_EQ(vertex.normal, vec3(0, 1, 0)) << "they go before smoothing groups";
}

TEST_F(SceneMeshOfAFile, TurnsNormalsWithWhatTheyBelongTo)
{
    const std::string normals = "vn 0 0 1\nvn 0 0 -1\n";
    const std::string flat = "v -8 -8 0\nv 8 -8 0\nv 8 8 0\nv -8 8 0\n" + normals;
    for (const char* face : {"f 1//1 2//1 3//1 4//1\n", "f 1//2 2//2 3//2 4//2\n",
                             "f 4//2 3//2 2//2 1//2\n", "f 4//1 3//1 2//1 1//1\n"}) {
        for (const Vertex& vertex : load(flat + face, 'z').vertices)
            EXPECT_EQ(vertex.normal, vec3(0, 1, 0)) << face;
    }
}

TEST_F(SceneMeshOfAFile, HasTheTextureCoordinatesOfItsFile)
{
    const std::string uvs = "vt 0.25 0.5 # 2D\nvt 2 -1 0\nvt 0.75\nvt nan 1\nvt\n";
    write("m.mtl", "newmtl m\nmap_Kd m.mtl\n");
    const Scene scene = load(square + uvs + "mtllib m.mtl\nusemtl m\nf 1/1 2/-4 3/3/ 4/4\n");
    for (size_t i = 0; i < scene.indices.size(); ++i) {
        const Vertex& vertex = scene.corner(i);
        const bool left = vertex.position.x < 0, back = vertex.position.z < 0;
        const vec2 expected =
            left ? (back ? vec2(0.25f, 0.5f) : vec2(2, -1)) : (back ? vec2(0) : vec2(0.75f, 0));
        EXPECT_EQ(vertex.uv, expected);
    }
    EXPECT_NE(warnings.find("line 8: 'vt nan 1': not as many numbers as it needs, 0 instead (and "
                            "1 more)\n"),
              std::string::npos)
        << warnings;
}

TEST_F(SceneMeshOfAFile, OfTheCourtyardHasAboutTwoThirdsOfItsCornersAsVertices)
{
    const Scene courtyard = load_file(find_file("common/assets/courtyard.obj"));
    EXPECT_LT(3 * courtyard.vertices.size(), 2 * courtyard.indices.size());
}
