// SPDX-License-Identifier: Apache-2.0
#include "hapticut/build/mesh_builder.hpp"

#include <gtest/gtest.h>

#include <limits>

#include "hapticut/core/errors.hpp"
#include "hapticut/core/units.hpp"
#include "support/mesh_measures.hpp"
#include "support/meshes.hpp"
#include "support/workpieces.hpp"

namespace hapticut::mesh_builder_test {
namespace {

using test::ball_mesh;
using test::cube_mesh;
using test::named;
using test::solid_volume;
using units::mm;
using units::mm3;

TEST(MeshBuilder, ABallConvergesToTheVolumeOfItsMesh) {
  const TriangleMesh ball = ball_mesh(Vec3(1, 2, 3) * mm, 2 * mm, 48);
  const double exact = test::signed_volume(ball);
  // The error of subsampling is noise from its lattice. The fraction of voxels at the surface bounds this error.
  for (const auto& [voxel_size, tolerance] : {std::pair{0.4 * mm, 2e-3}, {0.2 * mm, 7e-4}, {0.1 * mm, 2e-4}}) {
    const Workpiece workpiece = build_from_mesh(ball, named("clay"), {voxel_size, 8});
    EXPECT_NEAR(solid_volume(workpiece), exact, tolerance * exact) << "at " << voxel_size / mm << " mm";
  }
}

TEST(MeshBuilder, CentroidsOfCutVoxelsPutTheBodyWhereItIs) {
  const Vec3 center = Vec3(1.03, 2.01, 2.98) * mm;
  const Workpiece workpiece = build_from_mesh(ball_mesh(center, 2 * mm, 48), named("clay"), {0.4 * mm, 8});
  Vec3 sum = Vec3::Zero();
  double weight = 0, off_center = 0;
  workpiece.for_each_block([&](const BlockView& block) {
    for (int n = 0; n < kBlockVoxels; ++n) {
      const VoxelIndex at = voxel_at(block.origin, n);
      const double fill = workpiece.fill_at(at);
      const Vec3 offset = test::centroid_of(workpiece, at) * workpiece.voxel_size();
      const Vec3 p = workpiece.frame().center(at) + offset - center;
      sum += fill * p;
      weight += fill;
      if (fill > 0 && fill < 1) off_center += p.norm() < (p - offset).norm() ? 1 : -1;  // 1: inwards
    }
  });
  EXPECT_LT((sum / weight).norm(), 1e-3 * mm);
  EXPECT_GT(off_center, 100);
}

TEST(MeshBuilder, ACubeOnTheLatticeIsExactAndMadeOfTiles) {
  const Workpiece cube = build_from_mesh(cube_mesh(Vec3::Zero(), 6.4 * mm, 1), named("clay"), {0.1 * mm, 8});
  EXPECT_EQ(cube.solid_voxels(), 64 * 64 * 64);
  EXPECT_NEAR(solid_volume(cube), 262.144 * mm3, 1e-9 * mm3);
  EXPECT_EQ(cube.block({8, 8, 8}).material, nullptr);
}

TEST(MeshBuilder, AHoleInACubeIsClosed) {
  // 4 of 600 squares are missing. The criterion winding number > 1/2 closes the hole with a shallow cap.
  TriangleMesh cube = cube_mesh(Vec3::Zero(), 5 * mm, 10);
  const std::size_t last = cube.triangles.size() / 6 - 1;  // on the first face, x = 0
  cube.triangles.erase(cube.triangles.begin() + std::ptrdiff_t(last) - 95,
                       cube.triangles.begin() + std::ptrdiff_t(last) - 91);
  ASSERT_FALSE(test::is_closed(cube));
  const Workpiece workpiece = build_from_mesh(cube, named("clay"), {0.1 * mm, 4});
  EXPECT_NEAR(solid_volume(workpiece), 125 * mm3, 0.002 * 125 * mm3);
  EXPECT_EQ(workpiece.material_at({25, 25, 25}), 1);
}

TEST(MeshBuilder, OverlappingPartsOfOneSurfaceAreOneBody) {
  const TriangleMesh two = test::joined(cube_mesh(Vec3::Zero(), 2 * mm, 2), cube_mesh(Vec3(1, 0, 0) * mm, 2 * mm, 2));
  EXPECT_NEAR(solid_volume(build_from_mesh(two, named("clay"), {0.1 * mm, 4})), 12 * mm3, 0.01 * 12 * mm3);
}

TEST(MeshBuilder, TheLastShellThatEnclosesAPointWins) {
  const auto ball = [](double radius) { return ball_mesh(Vec3::Zero(), radius, 32); };
  const Workpiece nested = build_from_shells({{ball(3 * mm), 1}, {ball(2 * mm), 2}, {ball(1 * mm), kEmpty}},
                                             MaterialTable({named("enamel"), named("dentin")}), {0.1 * mm, 8});
  const double outer = test::signed_volume(ball(3 * mm)), middle = test::signed_volume(ball(2 * mm)),
               inner = test::signed_volume(ball(1 * mm));
  const auto amounts = nested.amounts();
  // A voxel with two materials counts for the material with the larger part.
  EXPECT_NEAR(amounts[0].volume, outer - middle, 0.005 * outer);
  EXPECT_NEAR(amounts[1].volume, middle - inner, 0.005 * middle);
  EXPECT_NEAR(amounts[0].volume + amounts[1].volume, outer - inner, 1e-3 * outer);
  const VoxelIndex center = {30, 30, 30};
  EXPECT_EQ(nested.material_at(center), kEmpty);
}

TEST(MeshBuilder, TheResultDoesNotDependOnTheNumberOfThreads) {
  const TriangleMesh ball = ball_mesh(Vec3::Zero(), 2 * mm, 24);
  const Workpiece first = build_from_mesh(ball, named("clay"), {0.1 * mm, 4});
  for (int round = 0; round < 3; ++round)
    EXPECT_EQ(build_from_mesh(ball, named("clay"), {0.1 * mm, 4}).hash(), first.hash());
}

TEST(MeshBuilder, ASurfaceThatEnclosesNothingIsRefused) {
  const auto build = [](const TriangleMesh& mesh) { return build_from_mesh(mesh, named("clay"), {0.1 * mm, 4}); };
  EXPECT_THROW((void)build({}), Error);
  TriangleMesh plate = cube_mesh(Vec3::Zero(), 5 * mm, 4);
  plate.triangles.resize(plate.triangles.size() / 6);
  EXPECT_THROW((void)build(plate), Error);
  TriangleMesh flat = cube_mesh(Vec3::Zero(), 5 * mm, 4);
  for (Vec3& v : flat.vertices) v.z() = 0;
  EXPECT_THROW((void)build(flat), Error);
  TriangleMesh loose;  // unconnected triangles
  for (int n = 0; n < 100; ++n) {
    const auto first = std::uint32_t(loose.vertices.size());
    for (int k = 0; k < 3; ++k) {
      const double a = 12.9898 * (3 * n + k + 1), b = 78.233 * (3 * n + k + 1), c = 37.719 * (3 * n + k + 1);
      loose.vertices.push_back(3 * mm * Vec3(std::sin(a * a), std::sin(b * b), std::sin(c * c)));
    }
    loose.triangles.push_back({first, first + 1, first + 2});
  }
  EXPECT_THROW((void)build(loose), Error);
}

TEST(MeshBuilder, BadInputIsRefused) {
  const TriangleMesh cube = cube_mesh(Vec3::Zero(), 1 * mm, 1);
  const MaterialTable clay({named("clay")});
  EXPECT_THROW((void)build_from_shells({}, clay), Error);
  EXPECT_THROW((void)build_from_shells({{cube, 2}}, clay), Error);
  EXPECT_THROW((void)build_from_shells({{cube, 1}, {cube, kEmpty}}, clay), Error);  // nothing is left
  for (const double voxel_size : {0.0, -1.0, std::numeric_limits<double>::quiet_NaN(), 1e-12})
    EXPECT_THROW((void)build_from_mesh(cube, named("clay"), {voxel_size, 4}), Error);
  EXPECT_THROW((void)build_from_mesh(cube, named("clay"), {0.1 * mm, 0}), Error);
  TriangleMesh broken = cube;
  broken.triangles[3][1] = 1000;
  EXPECT_THROW((void)build_from_mesh(broken, named("clay")), Error);
  broken = cube;
  broken.vertices[3].y() = std::numeric_limits<double>::infinity();
  EXPECT_THROW((void)build_from_mesh(broken, named("clay")), Error);
}

}  // namespace
}  // namespace hapticut::mesh_builder_test
