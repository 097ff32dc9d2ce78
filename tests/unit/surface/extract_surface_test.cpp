// SPDX-License-Identifier: Apache-2.0
#include "hapticut/surface/extract_surface.hpp"

#include <gtest/gtest.h>

#include "hapticut/core/errors.hpp"
#include "hapticut/core/units.hpp"
#include "hapticut/workpiece/builders.hpp"
#include "support/mesh_measures.hpp"
#include "support/named_material.hpp"

namespace hapticut::extract_surface_test {
namespace {

using test::is_closed;
using test::named;
using test::signed_volume;
using units::mm;

TEST(Surface, OfABallConvergesToItsVolumeAndRadius) {
  double previous_error = 1;
  for (const double voxel_size : {0.2 * mm, 0.1 * mm, 0.05 * mm}) {
    const TriangleMesh mesh = extract_surface(build_sphere(Vec3(1, 2, 3) * mm, 2 * mm, voxel_size, named("clay"))).mesh;
    ASSERT_TRUE(is_closed(mesh));
    const double exact = 4.0 / 3 * units::kPi * std::pow(2 * mm, 3);
    const double error = std::abs(signed_volume(mesh) / exact - 1);
    EXPECT_LT(error, previous_error / 2.5);  // second order, with a margin for the noise of subsampling
    previous_error = error;
    for (const Vec3& v : mesh.vertices) EXPECT_NEAR((v - Vec3(1, 2, 3) * mm).norm(), 2 * mm, 0.15 * voxel_size);
  }
  EXPECT_LT(previous_error, 2e-3);
}

TEST(Surface, OfABlockOfTilesIsClosedAndHasItsVolume) {
  // 128^3 voxels: one tile without a cut; the surface lies on the faces of the voxels.
  const Workpiece block = build_block({Vec3::Zero(), Vec3(12.8, 12.8, 12.8) * mm}, 0.1 * mm, named("clay"));
  const TriangleMesh mesh = extract_surface(block).mesh;
  ASSERT_TRUE(is_closed(mesh));
  EXPECT_GT(signed_volume(mesh), 0);
  EXPECT_NEAR(signed_volume(mesh), std::pow(12.8 * mm, 3), 1e-3 * std::pow(12.8 * mm, 3));  // edges are bevelled
  for (const Vec3& v : mesh.vertices) {
    EXPECT_GE(v.minCoeff(), -0.001 * mm);
    EXPECT_LE(v.maxCoeff(), 12.801 * mm);
  }
}

TEST(Surface, OfAPartlyFilledRowOfVoxelsLiesWhereTheBlockEnds) {
  const Workpiece block = build_block({Vec3::Zero(), Vec3(4, 4, 2.03) * mm}, 0.1 * mm, named("clay"));
  double highest = 0;
  for (const Vec3& v : extract_surface(block).mesh.vertices) highest = std::max(highest, v.z());
  // From the centre of the full row (1.95 mm) to that of the row filled to 0.3 (2.05 mm), the fill passes 1/2 at 5/7.
  EXPECT_NEAR(highest, (1.95 + 0.1 * 5 / 7) * mm, 1e-6 * mm);
}

TEST(Surface, FollowsTheRotationAndPositionOfTheGrid) {
  GridFrame frame{0.1 * mm, {rotation_from_vector({0.5, 0.2, -0.3}), Vec3(10, -20, 30) * mm}};
  const Workpiece cube = Workpiece::from_blocks({{0, 0, 0}, {19, 19, 19}}, frame, MaterialTable({named("clay")}),
                                                [](const VoxelIndex&, BlockContent&) { return BlockKind::solid(1); });
  const TriangleMesh mesh = extract_surface(cube).mesh;
  ASSERT_TRUE(is_closed(mesh));
  EXPECT_NEAR(signed_volume(mesh), std::pow(2 * mm, 3), 0.01 * std::pow(2 * mm, 3));
  Vec3 sum = Vec3::Zero();
  for (const Vec3& v : mesh.vertices) sum += v;
  const Vec3 middle = frame.X_WV * Vec3(0.95 * mm, 0.95 * mm, 0.95 * mm);
  EXPECT_LT((sum / double(mesh.vertices.size()) - middle).norm(), 0.001 * mm);
}

TEST(Surface, AnEnclosedCavityHasASurfaceThatPointsIntoIt) {
  const auto distance = [](const Vec3& p) { return std::max(p.norm() - 2 * mm, 1 * mm - p.norm()); };
  const Workpiece shell = build_body(
      {{Vec3::Constant(-2 * mm), Vec3::Constant(2 * mm)}, distance, [](const Vec3&) { return MaterialId(1); }},
      0.1 * mm, MaterialTable({named("clay")}));
  const TriangleMesh mesh = extract_surface(shell).mesh;
  ASSERT_TRUE(is_closed(mesh));
  const double exact = 4.0 / 3 * units::kPi * (8 - 1) * units::mm3;
  EXPECT_NEAR(signed_volume(mesh), exact, 0.01 * exact);
}

TEST(Surface, VerticesKnowTheirMaterialAndEachMaterialHasItsOwnSurface) {
  const Workpiece slab = build_layered_slab({Vec3::Zero(), Vec3(4, 4, 4) * mm}, 0.1 * mm,
                                            {{named("upper"), 1 * mm}, {named("lower"), 3 * mm}});
  const WorkpieceSurface surface = extract_surface(slab);
  ASSERT_EQ(surface.materials.size(), surface.mesh.vertices.size());
  for (std::size_t n = 0; n < surface.materials.size(); ++n) {
    const double z = surface.mesh.vertices[n].z();
    if (std::abs(z - 3 * mm) < 0.06 * mm) continue;  // within half a voxel of the interface either is right
    EXPECT_EQ(surface.materials[n], z > 3 * mm ? 1 : 2);
  }
  const TriangleMesh upper = extract_surface(slab, 1), lower = extract_surface(slab, 2);
  ASSERT_TRUE(is_closed(upper));
  ASSERT_TRUE(is_closed(lower));
  EXPECT_NEAR(signed_volume(upper), 16 * units::mm3, 0.02 * 16 * units::mm3);
  EXPECT_NEAR(signed_volume(lower), 48 * units::mm3, 0.02 * 48 * units::mm3);
  EXPECT_THROW((void)extract_surface(slab, 3), Error);
}

TEST(Surface, OfNothingIsEmpty) {
  const Workpiece nothing = Workpiece::from_blocks({{0, 0, 0}, {7, 7, 7}}, GridFrame{}, MaterialTable({named("clay")}),
                                                   [](const VoxelIndex&, BlockContent&) { return BlockKind::empty(); });
  const WorkpieceSurface surface = extract_surface(nothing);
  EXPECT_TRUE(surface.mesh.triangles.empty());
  EXPECT_TRUE(surface.materials.empty());
}

}  // namespace
}  // namespace hapticut::extract_surface_test
