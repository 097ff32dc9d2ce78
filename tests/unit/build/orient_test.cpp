// SPDX-License-Identifier: Apache-2.0
#include "build/orient.hpp"

#include <gtest/gtest.h>

#include "hapticut/build/mesh_builder.hpp"
#include "hapticut/core/errors.hpp"
#include "hapticut/workpiece/material_presets.hpp"
#include "support/mesh_measures.hpp"
#include "support/meshes.hpp"

namespace hapticut::orient_test {
namespace {

TriangleMesh flipped(TriangleMesh mesh) {
  for (auto& t : mesh.triangles) std::swap(t[1], t[2]);
  return mesh;
}

/// Two concentric balls, the second facing inwards: a shell with a cavity.
TriangleMesh hollow_ball(const Vec3& center) {
  return test::joined(test::ball_mesh(center, 2e-3, 8), flipped(test::ball_mesh(center, 1e-3, 8)));
}

TEST(Orient, ASurfaceWithRandomlyFlippedFacesEnclosesTheSameVolume) {
  const TriangleMesh right = test::ball_mesh(Vec3::Zero(), 2e-3, 8);
  TriangleMesh mixed = right;
  for (std::size_t n = 0; n < mixed.triangles.size(); n += 3) std::swap(mixed.triangles[n][0], mixed.triangles[n][1]);
  const TriangleMesh once = oriented(mixed);
  EXPECT_EQ(oriented(once).triangles, once.triangles);
  const Material bone = presets::cortical_bone();
  EXPECT_EQ(build_from_mesh(mixed, bone).hash(), build_from_mesh(right, bone).hash());
}

TEST(Orient, ASurfaceWithRightOrientationDoesNotChange) {
  for (const TriangleMesh& mesh : {test::ball_mesh(Vec3::Zero(), 2e-3, 8), hollow_ball(Vec3::Zero())})
    EXPECT_EQ(oriented(mesh).triangles, mesh.triangles);
}

TEST(Orient, APieceThatIsInsideOutBesideAnotherIsFlippedWithItsCavity) {
  const TriangleMesh one = hollow_ball(Vec3::Zero()), other = hollow_ball(Vec3(7e-3, 0, 0)),
                     both = test::joined(one, other);
  const Material bone = presets::cortical_bone();
  const Workpiece right = build_from_mesh(both, bone);
  EXPECT_EQ(build_from_mesh(test::joined(one, flipped(other)), bone).hash(), right.hash());
  const double expected = test::signed_volume(both);
  EXPECT_NEAR(right.amounts().at(0).volume, expected, 0.02 * expected) << "the cavities are empty";
}

/// A box on the lattice of voxels of 0.25 mm.
TriangleMesh box_mm(const Vec3& min, const Vec3& size) {
  TriangleMesh mesh = test::cube_mesh(Vec3::Zero(), 1e-3, 1);
  for (Vec3& v : mesh.vertices) v = min * 1e-3 + v.cwiseProduct(size);
  return mesh;
}

TriangleMesh mirrored_in_x(TriangleMesh mesh, double plane) {
  for (Vec3& v : mesh.vertices) v.x() = 2 * plane - v.x();
  return mesh;  // it faces inwards, and its faces at the plane are those of the original
}

double volume_mm3(const TriangleMesh& mesh) {
  return build_from_mesh(mesh, presets::dentin(), {0.25e-3, 4}).amounts().at(0).volume * 1e9;
}

TEST(Orient, BodiesThatShareAnEdgeOrAFaceAreWholeIfOneIsInsideOut) {
  const Vec3 two(2, 2, 2);
  const TriangleMesh one = box_mm(Vec3::Zero(), two);
  struct Case {
    TriangleMesh other;
    double volume;
  };
  const Case cases[] = {
      {box_mm({2, 2, 0}, two), 16},       {box_mm({2, 2, 0}, {3, 3, 2}), 26},     {box_mm({2, 2, 0}, {1, 1, 2}), 10},
      {box_mm({2, 0, 0}, two), 16},       {box_mm({2, 0, 0}, {4, 2, 2}), 24},     {box_mm({2, 2, 2}, two), 16},
      {box_mm({2, 0, 0}, {2, 1, 1}), 10}, {box_mm({2, 0.5, 0.5}, {2, 1, 1}), 10}, {box_mm({5, 0, 0}, two), 16}};
  for (const Case& c : cases) {
    SCOPED_TRACE(c.volume);
    EXPECT_NEAR(volume_mm3(test::joined(one, c.other)), c.volume, 1e-6);
    EXPECT_NEAR(volume_mm3(test::joined(one, flipped(c.other))), c.volume, 1e-6);
    EXPECT_NEAR(volume_mm3(test::joined(flipped(one), c.other)), c.volume, 1e-6);
    EXPECT_NEAR(volume_mm3(test::joined(flipped(c.other), one)), c.volume, 1e-6);
    EXPECT_NEAR(volume_mm3(flipped(test::joined(one, c.other))), c.volume, 1e-6);
  }
  EXPECT_NEAR(volume_mm3(test::joined(one, mirrored_in_x(one, 2e-3))), 16, 1e-6);
  const TriangleMesh middle = flipped(box_mm({2, 0, 0}, two)), last = box_mm({4, 0, 0}, two);
  EXPECT_NEAR(volume_mm3(test::joined(test::joined(one, middle), last)), 24, 1e-6);
  const TriangleMesh at_edge = flipped(box_mm({2, 2, 0}, two)), apart = box_mm({9, 0, 0}, two);
  EXPECT_NEAR(volume_mm3(test::joined(test::joined(one, at_edge), apart)), 24, 1e-6);
}

TEST(Orient, ACavityThatReachesTheSurfaceOfItsBodyStaysACavity) {
  const TriangleMesh body = box_mm(Vec3::Zero(), {2, 2, 2});
  const TriangleMesh slot = flipped(box_mm({1, 1, 0}, {1, 1, 2})), corner = flipped(box_mm(Vec3::Zero(), {1, 1, 1}));
  EXPECT_NEAR(volume_mm3(test::joined(body, slot)), 6, 1e-6);
  EXPECT_NEAR(volume_mm3(flipped(test::joined(body, slot))), 6, 1e-6);
  EXPECT_NEAR(volume_mm3(test::joined(body, corner)), 7, 1e-6);
}

TEST(WorkEstimate, IsReportedBeforeTheWorkAndRefusedAboveTheLimitUnlessAllowed) {
  const TriangleMesh ball = test::ball_mesh(Vec3::Zero(), 2e-3, 8);
  WorkEstimate estimated;
  MeshImport options;
  options.observer = [&](const WorkEstimate& estimate) { estimated = estimate; };
  const Workpiece workpiece = build_from_mesh(ball, presets::cortical_bone(), options);
  EXPECT_NEAR(estimated.voxels, 41.0 * 41 * 41, 0.1 * 41 * 41 * 41);
  EXPECT_GT(estimated.cut_voxels, 4 * 3.14 * 20 * 20);
  EXPECT_LT(estimated.seconds, 1);
  EXPECT_GT(3 * estimated.memory_bytes, double(workpiece.memory_bytes()));
  const WorkEstimate large = {1e12, 1e9, 1.1 * kMaxBuildMemory, 10};
  EXPECT_THROW(require_allowed(large, false), Error);
  EXPECT_NO_THROW(require_allowed(large, true));
  EXPECT_THROW(require_allowed({1e9, 1e9, 1e9, 1.1 * kMaxBuildTime}, false), Error);
}

}  // namespace
}  // namespace hapticut::orient_test
