// Scenes whose faces run around the wrong way, or both ways, or whichever way.
#include "common/scene/orientation.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

using glm::vec3;

namespace {

using Face = std::vector<vec3>;  // its corners, counter-clockwise as seen from its front

// Which way each face faces: its area along its normal, in thousandths of a square metre.
std::vector<vec3> facing(const std::vector<Face>& faces)
{
    std::vector<vec3> result;
    for (const Face& face : faces) {
        vec3 sum(0);
        for (size_t i = 1; i + 1 < face.size(); ++i)
            sum += 0.5f * glm::cross(face[i] - face[0], face[i + 1] - face[0]);
        result.push_back(glm::round(1000.0f * sum));
    }
    return result;
}

// The same after orient. Each face has points of its own, as files often have.
std::vector<vec3> facing_after_orient(const std::vector<Face>& faces)
{
    std::vector<Polygon> polygons;
    std::vector<vec3> points;
    for (const Face& face : faces) {
        polygons.emplace_back();
        for (const vec3& corner : face) {
            polygons.back().corners.push_back({uint32_t(points.size())});
            points.push_back(corner);
        }
    }
    orient(polygons, points);
    std::vector<Face> oriented;
    for (const Polygon& polygon : polygons) {
        oriented.emplace_back();
        for (const Corner& corner : polygon.corners)
            oriented.back().push_back(points[corner.point]);
    }
    return facing(oriented);
}

Face over(Face face)
{
    std::reverse(face.begin(), face.end());
    return face;
}

std::vector<Face> over(std::vector<Face> faces)
{
    for (Face& face : faces) face = over(face);
    return faces;
}

std::vector<Face> operator+(std::vector<Face> a, const std::vector<Face>& b)
{
    a.insert(a.end(), b.begin(), b.end());
    return a;
}

// Facing up: a strip along z from one edge to the other.
Face sheet(float x0, float y0, float x1, float y1)
{
    return {{x0, y0, -3}, {x0, y0, 3}, {x1, y1, 3}, {x1, y1, -3}};
}

// Facing outwards: bottom, top, left, right, back, front.
std::vector<Face> box(vec3 low, vec3 high)
{
    const float x0 = low.x, y0 = low.y, z0 = low.z, x1 = high.x, y1 = high.y, z1 = high.z;
    return {{{x0, y0, z0}, {x1, y0, z0}, {x1, y0, z1}, {x0, y0, z1}},
            {{x0, y1, z0}, {x0, y1, z1}, {x1, y1, z1}, {x1, y1, z0}},
            {{x0, y0, z0}, {x0, y0, z1}, {x0, y1, z1}, {x0, y1, z0}},
            {{x1, y0, z0}, {x1, y1, z0}, {x1, y1, z1}, {x1, y0, z1}},
            {{x0, y0, z0}, {x0, y1, z0}, {x1, y1, z0}, {x1, y0, z0}},
            {{x0, y0, z1}, {x1, y0, z1}, {x1, y1, z1}, {x0, y1, z1}}};
}

std::vector<Face> without(std::vector<Face> faces, size_t which)
{
    faces.erase(faces.begin() + std::ptrdiff_t(which));
    return faces;
}

// The wall of a pipe or a limb along the x axis, open at both ends, facing outwards.
std::vector<Face> pipe(vec3 from, vec3 to, float from_radius, float to_radius)
{
    std::vector<Face> faces;
    for (int k = 0; k < 8; ++k) {
        const auto corner = [&](vec3 end, float radius, int n) {
            const float angle = float(n % 8) * float(M_PI) / 4;
            return end + radius * vec3(0, std::cos(angle), std::sin(angle));
        };
        faces.push_back({corner(from, from_radius, k), corner(from, from_radius, k + 1),
                         corner(to, to_radius, k + 1), corner(to, to_radius, k)});
    }
    return faces;
}

}  // namespace

TEST(Orientation, OfSheetsIsUp)
{
    // Flat, leaning, and a vault, a ditch and a stair of several faces.
    const std::vector<std::vector<Face>> sheets = {
        {sheet(-3, 0, 3, 0)},
        {sheet(0, 0, 1, 1.5f)},
        {sheet(-2, 0, 0, 1), sheet(0, 1, 2, 0)},
        {sheet(-2, 1, -1, 0), sheet(-1, 0, 1, 0), sheet(1, 0, 2, 1)},
        {sheet(0, 0, 1, 0), sheet(1, 0, 1, 1), sheet(1, 1, 2, 1), sheet(2, 1, 2, 2)}};
    for (const std::vector<Face>& faces : sheets) {
        EXPECT_EQ(facing_after_orient(faces), facing(faces));
        EXPECT_EQ(facing_after_orient(over(faces)), facing(faces));
    }
}

TEST(Orientation, OfSheetsIsUpEachForItself)
{
    const std::vector<Face> faces = {sheet(-8, 0, 8, 0), sheet(-3, 2, 3, 2), sheet(4, 3, 8, 3)};
    EXPECT_EQ(facing_after_orient({faces[0], over(faces[1]), faces[2]}), facing(faces));
    EXPECT_EQ(facing_after_orient(over(faces)), facing(faces));
}

TEST(Orientation, OfBodiesIsOutwards)
{
    const std::vector<Face> cube = box({-1, 0, -1}, {1, 2, 1}),
                            plank = box({2, 1, 2}, {6, 1.1f, 5});
    for (const std::vector<Face>& faces : {cube, plank, cube + plank}) {
        EXPECT_EQ(facing_after_orient(faces), facing(faces));
        EXPECT_EQ(facing_after_orient(over(faces)), facing(faces));
    }
    EXPECT_EQ(facing_after_orient(over(cube) + plank), facing(cube + plank));
}

TEST(Orientation, OfBodiesWithAHoleIsOutwards)
{
    const std::vector<Face> cube = box({-1, 0, -1}, {1, 2, 1});
    for (const size_t hole : {0, 2, 3, 4, 5}) {  // the bottom, or a side
        EXPECT_EQ(facing_after_orient(without(cube, hole)), facing(without(cube, hole)));
        EXPECT_EQ(facing_after_orient(over(without(cube, hole))), facing(without(cube, hole)));
    }
    // Through an open top snow falls on the bottom.
    EXPECT_EQ(facing_after_orient(without(cube, 1)), facing(over(without(cube, 1))));
}

TEST(Orientation, OfPipesAndLimbsIsOutwards)
{
    for (const std::vector<Face>& faces :
         {pipe({0, 0, 0}, {3, 0, 0}, 0.2f, 0.2f), pipe({0, 0, 0}, {3, 1, 0}, 0.2f, 0.1f),
          pipe({0, 1, 0}, {3, 0, 0}, 0.2f, 0.1f)}) {
        EXPECT_EQ(facing_after_orient(faces), facing(faces));
        EXPECT_EQ(facing_after_orient(over(faces)), facing(faces));
    }
}

TEST(Orientation, OfWallsStays)
{
    const std::vector<Face> wall = {{{-3, 0, 0}, {3, 0, 0}, {3, 3, 0}, {-3, 3, 0}}};
    EXPECT_EQ(facing_after_orient(wall), facing(wall));
    EXPECT_EQ(facing_after_orient(over(wall)), facing(over(wall)));
}

TEST(Orientation, IsTheSameAllOverASurface)
{
    std::mt19937 random(1);
    std::vector<Face> hills, cube = box({-1, 0, -1}, {1, 2, 1});
    const auto point = [](int i, int j) { return vec3(i, 0.1f * float((3 * i + 5 * j) % 7), j); };
    for (int i = 0; i < 20; ++i) {
        for (int j = 0; j < 20; ++j) {
            hills.push_back({point(i, j), point(i, j + 1), point(i + 1, j + 1)});
            hills.push_back({point(i, j), point(i + 1, j + 1), point(i + 1, j)});
        }
    }
    for (const std::vector<Face>& faces : {hills, cube}) {
        std::vector<Face> mixed = faces;
        for (Face& face : mixed) {
            if (random() % 2) face = over(face);
        }
        EXPECT_EQ(facing_after_orient(mixed), facing(faces));
    }
}

TEST(Orientation, OfBodiesThatTouchIsOutwards)
{
    // Two that share a side, two that share an edge, and one that stands on a floor of which the
    // edges of its own bottom are a part.
    const std::vector<Face> first = box({0, 0, 0}, {1, 1, 1}), beside = box({1, 0, 0}, {2, 1, 1}),
                            across = box({1, 1, 0}, {2, 2, 1});
    const std::vector<Face> floor = {{{0, 0, 0}, {0, 0, 1}, {1, 0, 1}, {1, 0, 0}},
                                     {{1, 0, 0}, {1, 0, 1}, {9, 0, 1}, {9, 0, 0}},
                                     {{0, 0, 1}, {0, 0, 9}, {1, 0, 9}, {1, 0, 1}}};
    EXPECT_EQ(facing_after_orient(first + across), facing(first + across));
    // Of the side that both have, one copy is left; of the floor below the body, its bottom.
    EXPECT_EQ(facing_after_orient(first + beside), facing(first + without(beside, 2)));
    EXPECT_EQ(facing_after_orient(floor + without(first, 0)), facing(floor + without(first, 0)));
}

TEST(Orientation, OfTwoSidesIsThatOfOne)
{
    const std::vector<Face> faces = {sheet(-8, 0, 8, 0), sheet(-3, 2, 3, 2), sheet(0, 3, 1, 4.5f)};
    EXPECT_EQ(facing_after_orient(faces + over(faces)), facing(faces));
    EXPECT_EQ(facing_after_orient(over(faces) + faces), facing(faces));
    const std::vector<Face> cube = box({-1, 0, -1}, {1, 2, 1});
    EXPECT_EQ(facing_after_orient(cube + over(cube)), facing(cube));
    EXPECT_EQ(facing_after_orient(over(cube) + cube), facing(cube));
    // In any order of corners.
    const vec3 a(0), b(0, 0, 1), c(1, 0, 1), d(1, 0, 0);
    for (const Face& copy : {Face{a, b, c}, Face{b, c, a}, Face{c, a, b}, Face{a, c, b},
                             Face{c, b, a}, Face{b, a, c}}) {
        EXPECT_EQ(facing_after_orient({copy, {a, b, c}}), facing({{a, b, c}}));
    }
    EXPECT_EQ(facing_after_orient({{a, b, c, d}, {c, b, a, d}}), facing({{a, b, c, d}}));
    EXPECT_EQ(facing_after_orient({{a, b, c, d}, {a, b, c}}).size(), 2u);
}

TEST(Orientation, IsFoundForWhatHasNone)
{
    // Faces without area, one that meets itself, more than two along an edge, and a Moebius strip.
    const vec3 a(0), b(0, 0, 1), c(1, 0, 1);
    EXPECT_EQ(facing_after_orient({{a, a, a}, {a, b, a}, {a, b, b}}).size(), 3u);
    EXPECT_EQ(facing_after_orient({{a, b, c, b}, {c, b, a}, {a, b, c}}).size(), 2u);
    EXPECT_EQ(
        facing_after_orient({{a, b, c}, {a, b, vec3(0, 1, 0)}, {a, b, vec3(0, -1, 0)}}).size(), 3u);
    std::vector<Face> strip;
    const auto edge = [](int n) {
        const float turn = float(n) * float(M_PI) / 10, twist = turn / 2;
        const vec3 out(std::cos(turn), 0, std::sin(turn)), up(0, 1, 0);
        const vec3 across = std::cos(twist) * up + std::sin(twist) * out;
        return std::pair(3.0f * out + across, 3.0f * out - across);
    };
    for (int n = 0; n < 20; ++n) {
        const auto [p, q] = edge(n);
        auto [r, s] = n == 19 ? std::pair(edge(0).second, edge(0).first) : edge(n + 1);
        strip.push_back({p, q, s, r});
    }
    EXPECT_EQ(facing_after_orient(strip).size(), 20u);
}
