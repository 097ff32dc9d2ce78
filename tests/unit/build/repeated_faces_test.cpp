// SPDX-License-Identifier: Apache-2.0
// Faces that are there more than once, and parts of a surface that would be lost.
#include "build/repeated_faces.hpp"

#include <gtest/gtest.h>

#include "hapticut/build/mesh_builder.hpp"
#include "hapticut/core/units.hpp"
#include "hapticut/workpiece/material_presets.hpp"
#include "support/mesh_measures.hpp"
#include "support/meshes.hpp"
#include "support/refusal.hpp"

namespace hapticut::repeated_faces_test {
namespace {

using units::mm;
using units::mm3;

TriangleMesh cube(const Vec3& min_mm, double edge_mm) { return test::cube_mesh(min_mm * mm, edge_mm * mm, 2); }

TriangleMesh turned(TriangleMesh mesh) {
  for (auto& t : mesh.triangles) std::swap(t[1], t[2]);
  return mesh;
}

TriangleMesh two_sided(const TriangleMesh& mesh) { return test::joined(mesh, turned(mesh)); }

TriangleMesh without_last_faces(TriangleMesh mesh, std::size_t count) {
  mesh.triangles.resize(mesh.triangles.size() - count);
  return mesh;
}

double volume(const TriangleMesh& mesh) {
  return build_from_mesh(mesh, presets::dentin(), {0.25 * mm, 4}).amounts()[0].volume / mm3;
}

std::string refusal(const TriangleMesh& mesh) {
  return test::refusal([&] { return volume(mesh); });
}

constexpr std::size_t kSide = 8;  // triangles of a side of a cube

TEST(RepeatedFaces, OfABodySeenFromBothSidesCountOnceAloneAndBesideAnother) {
  const TriangleMesh one = cube({0, 0, 0}, 4), other = cube({6, 0, 0}, 3);
  EXPECT_NEAR(volume(two_sided(other)), 27, 1e-6);
  EXPECT_NEAR(volume(test::joined(one, two_sided(other))), 91, 1e-6);
  EXPECT_NEAR(volume(test::joined(two_sided(one), two_sided(other))), 91, 1e-6);
  EXPECT_NEAR(volume(test::joined(one, two_sided(turned(other)))), 91, 1e-6);
}

TEST(RepeatedFaces, OfTheSameWayRoundCountOnce) {
  const TriangleMesh one = cube({0, 0, 0}, 4), other = cube({6, 0, 0}, 3);
  EXPECT_NEAR(volume(test::joined(one, test::joined(other, other))), 91, 1e-6);
  EXPECT_NEAR(volume(test::joined(turned(one), test::joined(other, other))), 91, 1e-6);
  TriangleMesh one_side_twice = one;
  one_side_twice.triangles.insert(one_side_twice.triangles.end(), one.triangles.end() - kSide, one.triangles.end());
  EXPECT_EQ(without_repeated_faces(one_side_twice).triangles, one.triangles);
  EXPECT_NEAR(volume(test::joined(one_side_twice, turned(other))), 91, 1e-6);
}

TEST(RepeatedFaces, OnOneSideOfABodyAloneCloseIt) {
  const TriangleMesh one = cube({0, 0, 0}, 4);
  TriangleMesh partly = one;
  for (std::size_t n = 0; n < kSide; ++n) {
    const auto& [a, b, c] = one.triangles[one.triangles.size() - 1 - n];
    partly.triangles.push_back({a, c, b});
  }
  EXPECT_NEAR(volume(partly), 64, 1e-6);
}

TEST(RepeatedFaces, SharedByTwoBodiesLeaveBothWhole) {
  const TriangleMesh both = test::joined(cube({0, 0, 0}, 4), cube({4, 0, 0}, 4));
  EXPECT_NEAR(volume(both), 128, 1e-6);
  // Eight cubes around a point: twelve shared faces, and no edge of the faces inside is at the outside.
  TriangleMesh eight;
  for (int n = 0; n < 8; ++n) eight = test::joined(eight, cube(2.0 * Vec3(n & 1, n >> 1 & 1, n >> 2 & 1), 2));
  EXPECT_NEAR(volume(eight), 64, 1e-6);
  // A body in the corner of another shares three of its faces, the same way round.
  TriangleMesh corner = test::cube_mesh(Vec3::Zero(), 2 * mm, 1), around = test::cube_mesh(Vec3::Zero(), 4 * mm, 2);
  EXPECT_NEAR(volume(test::joined(around, corner)), 64, 1e-6);
}

TEST(RepeatedFaces, WithoutAreaAreDropped) {
  TriangleMesh mesh = cube({0, 0, 0}, 4);
  const auto triangles = mesh.triangles;
  mesh.triangles.push_back({0, 0, 1});
  mesh.triangles.push_back({5, 6, 5});
  EXPECT_EQ(without_repeated_faces(mesh).triangles, triangles);
}

TEST(RepeatedFaces, ThatMayBeABodyOrAWallAreRefusedAndReadAfterTheCure) {
  const TriangleMesh one = cube({0, 0, 0}, 4), open = without_last_faces(cube({6, 0, 0}, 3), 1);
  const std::string said = refusal(test::joined(one, two_sided(open)));
  EXPECT_NE(said.find("two-sided"), std::string::npos) << said;
  EXPECT_NE(said.find("delete one of each two, or both."), std::string::npos) << said;
  EXPECT_NEAR(volume(test::joined(one, open)), 91, 0.5);
  EXPECT_NEAR(volume(two_sided(open)), 27, 0.5) << "alone it can only be a body";
  // A flat wall encloses nothing.
  TriangleMesh wall = cube({0, 0, 0}, 4);
  wall.triangles.resize(kSide);
  for (Vec3& v : wall.vertices) v.y() += 20 * mm;
  EXPECT_NEAR(volume(test::joined(one, two_sided(wall))), 64, 1e-6);
}

TEST(LostParts, OfAClosedBodyInsideOutBesideAnOpenOneAreTurned) {
  const TriangleMesh open = without_last_faces(cube({0, 0, 0}, 4), 1);
  for (const TriangleMesh& other : {cube({6, 0, 0}, 3), cube({-5, 0, 0}, 3), cube({6, 0, 0}, 4.5)}) {
    const double whole = volume(test::joined(open, other));
    EXPECT_NEAR(whole, 64 + test::signed_volume(other) / mm3, 0.5);
    EXPECT_NEAR(volume(test::joined(open, turned(other))), whole, 1e-6);
    EXPECT_NEAR(volume(test::joined(turned(open), turned(other))), whole, 1e-6);
  }
  // Cavities stay, and turn with the body around them.
  const TriangleMesh hollow = test::joined(cube({6, 0, 0}, 3), turned(cube({7, 1, 1}, 1)));
  for (const TriangleMesh& mesh :
       {test::joined(open, hollow), test::joined(open, turned(hollow)), test::joined(turned(open), turned(hollow))})
    EXPECT_NEAR(volume(mesh), 90, 0.5);
  EXPECT_NEAR(volume(test::joined(open, turned(cube({2, 1, 1}, 1)))), 63, 0.5);
  const TriangleMesh open_cavity = turned(without_last_faces(cube({7, 1, 1}, 1), 1));
  EXPECT_NEAR(volume(test::joined(cube({6, 0, 0}, 3), open_cavity)), 26, 0.5);
}

TEST(LostParts, AreRefusedWithTheirPlaceAndReadAfterTheCure) {
  // From both sides with different triangles: no triangle is there twice.
  const TriangleMesh one = cube({0, 0, 0}, 4), other = test::cube_mesh(Vec3(6, 0, 0) * mm, 3 * mm, 2),
                     coarse = test::cube_mesh(Vec3(6, 0, 0) * mm, 3 * mm, 1);
  const std::string said = refusal(test::joined(one, test::joined(other, turned(coarse))));
  EXPECT_NE(said.find("around 7.5, 1.5, 1.5 mm, would be lost"), std::string::npos) << said;
  EXPECT_NE(said.find("keep one of each two"), std::string::npos) << said;
  EXPECT_NEAR(volume(test::joined(one, other)), 91, 1e-6);
  // Two open bodies, of which one is inside out.
  const TriangleMesh open = without_last_faces(one, 1), inside_out = turned(without_last_faces(other, 1));
  const std::string inwards = refusal(test::joined(open, inside_out));
  EXPECT_NE(inwards.find("turn them over"), std::string::npos) << inwards;
  EXPECT_NEAR(volume(test::joined(open, turned(inside_out))), 91, 0.7);
}

}  // namespace
}  // namespace hapticut::repeated_faces_test
