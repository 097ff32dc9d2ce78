// SPDX-License-Identifier: Apache-2.0
#include "workpiece/orient.hpp"

#include <gtest/gtest.h>

#include "hapticut/core/errors.hpp"
#include "hapticut/workpiece/material_presets.hpp"
#include "hapticut/workpiece/mesh_builder.hpp"
#include "support/meshes.hpp"

namespace hapticut::orient_test {
namespace {

TEST(Orient, ASurfaceWhoseFacesAreTurnedAtRandomEnclosesWhatItDid) {
  const TriangleMesh right = test::ball_mesh(Vec3::Zero(), 2e-3, 8);
  TriangleMesh mixed = right;
  for (std::size_t n = 0; n < mixed.triangles.size(); n += 3) std::swap(mixed.triangles[n][0], mixed.triangles[n][1]);
  TriangleMesh again = mixed;
  orient_alike(again);
  orient_alike(mixed);
  EXPECT_EQ(again.triangles, mixed.triangles);
  const Material bone = presets::cortical_bone();
  EXPECT_EQ(build_from_mesh(mixed, bone).hash(), build_from_mesh(right, bone).hash());
}

TEST(Orient, ASurfaceThatIsRightStaysAsItIs) {
  TriangleMesh mesh = test::ball_mesh(Vec3::Zero(), 2e-3, 8);
  for (auto& t : mesh.triangles) std::swap(t[0], t[1]);  // all inside out: alike, so nothing is to be done
  const auto before = mesh.triangles;
  orient_alike(mesh);
  EXPECT_EQ(mesh.triangles, before);
}

TEST(WorkEstimate, IsToldBeforeTheWorkAndRefusedAboveTheLimitUnlessAskedFor) {
  const TriangleMesh ball = test::ball_mesh(Vec3::Zero(), 2e-3, 8);
  WorkEstimate told;
  MeshImport options;
  options.tell = [&](const WorkEstimate& estimate) { told = estimate; };
  const Workpiece workpiece = build_from_mesh(ball, presets::cortical_bone(), options);
  EXPECT_NEAR(told.voxels, 41.0 * 41 * 41, 0.1 * 41 * 41 * 41);
  EXPECT_GT(told.cut_voxels, 4 * 3.14 * 20 * 20);
  EXPECT_LT(told.seconds, 1);
  EXPECT_GT(3 * told.memory_bytes, double(workpiece.memory_bytes()));
  const WorkEstimate large = {1e12, 1e9, 1.1 * kMostMemoryUnasked, 10};
  EXPECT_THROW(require_allowed(large, false), Error);
  EXPECT_NO_THROW(require_allowed(large, true));
  EXPECT_THROW(require_allowed({1e9, 1e9, 1e9, 1.1 * kMostSecondsUnasked}, false), Error);
}

}  // namespace
}  // namespace hapticut::orient_test
