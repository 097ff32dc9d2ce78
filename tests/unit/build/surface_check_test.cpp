// SPDX-License-Identifier: Apache-2.0
// Open surfaces, sheets, and walls that are too thin for the voxels.
#include "build/surface_check.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <string>
#include <vector>

#include "hapticut/build/mesh_builder.hpp"
#include "hapticut/core/units.hpp"
#include "hapticut/workpiece/material_presets.hpp"
#include "support/meshes.hpp"
#include "support/refusal.hpp"

namespace hapticut::surface_check_test {
namespace {

using units::mm;

/// What the builder says about a surface.
std::vector<std::string> said_about(const TriangleMesh& mesh, double voxel_size = 0.1 * mm) {
  std::vector<std::string> said;
  MeshImport options;
  options.voxel_size = voxel_size;
  options.warn = [&](const std::string& sentence) { said.push_back(sentence); };
  (void)build_from_mesh(mesh, presets::dentin(), options);
  return said;
}

/// A sheet of 10 mm by 10 mm that is a sine in x.
TriangleMesh wave(double amplitude) {
  constexpr int kCells = 40;
  TriangleMesh mesh;
  for (int i = 0; i <= kCells; ++i)
    for (int j = 0; j <= kCells; ++j) {
      const double x = 10.0 * i / kCells;
      mesh.vertices.push_back(Vec3(x, 10.0 * j / kCells, amplitude * std::sin(x)) * mm);
    }
  for (int i = 0; i < kCells; ++i)
    for (int j = 0; j < kCells; ++j) {
      const auto at = [&](int a, int b) { return std::uint32_t((i + a) * (kCells + 1) + j + b); };
      mesh.triangles.push_back({at(0, 0), at(1, 0), at(1, 1)});
      mesh.triangles.push_back({at(0, 0), at(1, 1), at(0, 1)});
    }
  return mesh;
}

/// A hollow cube of 4 mm.
TriangleMesh hollow_cube(double wall) {
  const Vec3 corner = Vec3::Constant(0.03 * mm);
  TriangleMesh inner = test::cube_mesh(corner + Vec3::Constant(wall), 4 * mm - 2 * wall, 1);
  for (auto& t : inner.triangles) std::swap(t[1], t[2]);
  return test::joined(test::cube_mesh(corner, 4 * mm, 1), inner);
}

TEST(SurfaceCheck, AClosedSurfaceIsBuiltWithoutAWord) {
  const TriangleMesh cube = test::cube_mesh(Vec3::Zero(), 2 * mm, 2);
  EXPECT_TRUE(said_about(cube).empty());
  EXPECT_TRUE(said_about(test::ball_mesh(Vec3::Zero(), 1 * mm, 16)).empty());
  EXPECT_TRUE(said_about(test::joined(cube, test::cube_mesh(Vec3(1, 0, 0) * mm, 2 * mm, 2))).empty()) << "overlap";
  EXPECT_TRUE(said_about(test::joined(cube, test::cube_mesh(Vec3(2, 0, 0) * mm, 2 * mm, 2))).empty()) << "touch";
}

TEST(SurfaceCheck, AnOpenSurfaceIsSaidWithItsEdgesAndItsVolume) {
  TriangleMesh open = test::cube_mesh(Vec3::Zero(), 2 * mm, 1);
  open.triangles.pop_back();
  const std::vector<std::string> said = said_about(open);
  ASSERT_EQ(said.size(), 1U);
  test::expect_part(said[0], "the surface is open: 3 of its edges have one face.");
  test::expect_part(said[0], " mm^3; close its holes first");
  EXPECT_EQ(said_about(wave(0.5)).size(), 1U);
}

TEST(SurfaceCheck, ASheetThatEnclosesLessThanALayerOfVoxelsIsRefused) {
  test::expect_refused([] { return said_about(wave(0.05)); }, {"open sheet", "close it to a body first."});
}

TEST(SurfaceCheck, WallsTooThinForTheVoxelsAreSaidWithBothVolumes) {
  const std::vector<std::string> said = said_about(hollow_cube(0.02 * mm));
  ASSERT_EQ(said.size(), 1U);
  test::expect_part(said[0], "too thin for voxels of 0.1 mm: it encloses 1.9009 mm^3");
  EXPECT_TRUE(said_about(hollow_cube(0.15 * mm)).empty());
}

}  // namespace
}  // namespace hapticut::surface_check_test
