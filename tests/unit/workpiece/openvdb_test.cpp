// SPDX-License-Identifier: Apache-2.0
#include "hapticut/workpiece/openvdb.hpp"

#include <gtest/gtest.h>
#include <openvdb/tools/LevelSetSphere.h>

#include <limits>

#include "hapticut/core/units.hpp"
#include "hapticut/workpiece/builders.hpp"
#include "support/named_material.hpp"
#include "support/refusal.hpp"

namespace hapticut::openvdb_test {
namespace {

using openvdb::FloatGrid;
using openvdb::Int32Grid;
using test::expect_refused;
using test::named;
using units::kPi;
using units::mm;
using units::mm3;

constexpr double kBallRadius_mm = 1.0;

MaterialTable two_materials() { return MaterialTable({named("lower"), named("upper")}); }

/// A ball in a grid whose world unit is the millimetre.
FloatGrid::Ptr ball_of_level_set() {
  openvdb::initialize();
  return openvdb::tools::createLevelSetSphere<FloatGrid>(float(kBallRadius_mm), openvdb::Vec3f(0.013F, 0, 0), 0.05F);
}

/// Ids of two slabs, below and above the plane k = 0, around the whole ball; the upper slab is a tile.
Int32Grid::Ptr two_layers(const FloatGrid& ball) {
  auto ids = Int32Grid::create(0);
  ids->setTransform(ball.transform().copy());
  ids->fill({{-32, -32, -32}, {31, 31, -1}}, 1);
  ids->fill({{-32, -32, 0}, {31, 31, 31}}, 2);
  return ids;
}

GridImport in_mm() {
  GridImport import;
  import.unit = mm;
  return import;
}

TEST(WorkpieceFromGrids, GivesEveryVoxelItsMaterial) {
  const auto ball = ball_of_level_set();
  const Workpiece workpiece = workpiece_from_grids(*ball, *two_layers(*ball), two_materials(), in_mm());
  const double half = 2 * kPi / 3 * std::pow(kBallRadius_mm, 3);
  const double slice = kPi * std::pow(kBallRadius_mm, 2) * 0.025;  // the plane passes half a voxel below the centre
  const double kSampling = 2e-3;                                   // trilinear distances and 8 points per edge
  EXPECT_NEAR(workpiece.amounts()[0].volume / mm3, half - slice, kSampling * half);
  EXPECT_NEAR(workpiece.amounts()[1].volume / mm3, half + slice, kSampling * half);
  EXPECT_EQ(workpiece.material_at({0, 0, -1}), 1);
  EXPECT_EQ(workpiece.material_at({0, 0, 0}), 2);
  EXPECT_EQ(workpiece.material_at({0, 0, 30}), kEmpty);
  EXPECT_NEAR(workpiece.voxel_size(), 0.05 * mm, 1e-12);
}

TEST(WorkpieceFromGrids, TakesFractionsFromAFogVolume) {
  openvdb::initialize();
  auto fog = FloatGrid::create(0.0F);
  fog->setGridClass(openvdb::GRID_FOG_VOLUME);
  fog->fill({{0, 0, 0}, {15, 15, 15}}, 1.0F);
  fog->tree().setValue({3, 4, 5}, 0.25F);
  fog->tree().setValue({3, 4, 16}, 1.0005F);  // full, and rounded
  auto ids = Int32Grid::create(1);            // a background of one material everywhere
  const Workpiece workpiece = workpiece_from_grids(*fog, *ids, two_materials());
  EXPECT_EQ(workpiece.fill_at({3, 4, 5}), 0.25);
  EXPECT_EQ(workpiece.fill_at({3, 4, 16}), 1.0);
  EXPECT_EQ(workpiece.solid_voxels(), 16 * 16 * 16 + 1);
  EXPECT_EQ(workpiece.voxel_size(), 1.0);
}

TEST(WorkpieceFromGrids, RestoresAWorkpieceFromItsGrids) {
  const Workpiece ball = build_sphere(Vec3(1, 2, 3) * mm, 1 * mm, 0.1 * mm, named("clay"));
  const auto density = density_grid(ball, mm);
  const auto ids = material_grid(ball, mm);
  const Workpiece again = workpiece_from_grids(*density, *ids, ball.materials(), in_mm());
  EXPECT_EQ(again.solid_voxels(), ball.solid_voxels());
  EXPECT_NEAR(again.amounts()[0].volume / ball.amounts()[0].volume, 1, 1e-12);  // rounding of the voxel size
  EXPECT_LT((again.frame().center({5, 6, 7}) - ball.frame().center({5, 6, 7})).norm(), 1e-12);
}

TEST(WorkpieceFromGrids, RefusesIdsThatAreNotInTheTable) {
  const auto ball = ball_of_level_set();
  for (const int id : {0, -1, 3, 255, 256}) {
    auto ids = Int32Grid::create(1);
    ids->setTransform(ball->transformPtr());
    ids->tree().setValue({0, 0, 0}, id);
    expect_refused([&] { (void)workpiece_from_grids(*ball, *ids, two_materials(), in_mm()); },
                   {("material id " + std::to_string(id)).c_str()});
  }
}

TEST(WorkpieceFromGrids, RefusesGridsOfDifferentPlaces) {
  const auto ball = ball_of_level_set();
  expect_refused([&] { (void)workpiece_from_grids(*ball, *Int32Grid::create(1), two_materials(), in_mm()); },
                 {"different transforms"});
}

TEST(WorkpieceFromGrid, RefusesGridsWithoutASolid) {
  const auto refused = [](const FloatGrid& grid, const char* reason, GridImport import = {}) {
    expect_refused([&] { (void)workpiece_from_grid(grid, named("clay"), import); }, {reason});
  };
  const auto ball = ball_of_level_set();

  FloatGrid unclear(*ball);
  unclear.setGridClass(openvdb::GRID_UNKNOWN);
  refused(unclear, "GridImport::kind");

  FloatGrid stretched(*ball);
  stretched.setTransform(openvdb::math::Transform::createLinearTransform());
  stretched.transform().preScale(openvdb::Vec3d(1, 1, 2));
  refused(stretched, "not cubes");

  FloatGrid frustum(*ball);
  frustum.setTransform(openvdb::math::Transform::createFrustumTransform(
      openvdb::BBoxd(openvdb::Vec3d(-9), openvdb::Vec3d(9)), 0.5, 10.0));
  refused(frustum, "not linear");

  FloatGrid broken(*ball);
  broken.tree().setValue({0, 0, 20}, std::numeric_limits<float>::quiet_NaN());
  refused(broken, "not finite");

  FloatGrid empty(1.0F);
  empty.setGridClass(openvdb::GRID_LEVEL_SET);
  refused(empty, "no active voxels");

  auto outside = openvdb::tools::createLevelSetSphere<FloatGrid>(1.0F, openvdb::Vec3f(0, 0, 0), 0.05F);
  for (auto value = outside->beginValueAll(); value; ++value) value.setValue(std::abs(*value) + 0.1F);
  refused(*outside, "encloses nothing");

  FloatGrid inverted(*ball);
  for (auto value = inverted.beginValueAll(); value; ++value) value.setValue(-*value);
  inverted.tree().root().setBackground(-ball->background(), /*updateChildNodes=*/false);
  refused(inverted, "Change their sign");

  FloatGrid other_unit(*ball);
  other_unit.setTransform(openvdb::math::Transform::createLinearTransform(1.0));
  refused(other_unit, "stores distances up to 0.15, but its voxels are 1 wide. Save it with distances in the unit");

  FloatGrid smoke(0.0F);
  smoke.setGridClass(openvdb::GRID_FOG_VOLUME);
  smoke.fill({{0, 0, 0}, {15, 15, 15}}, 10.0F);
  refused(smoke, "has the value 10, but values of a fog volume are filled fractions, 0 to 1. Scale the values");
  smoke.fill({{0, 0, 0}, {15, 15, 15}}, 1.0F);
  smoke.tree().setValue({3, 4, 5}, 1.01F);
  refused(smoke, "has the value 1.01");

  GridImport import;
  import.subsamples = 33;
  refused(*ball, "GridImport::subsamples", import);
  import = {};
  import.unit = 0;
  refused(*ball, "length of one world unit", import);
}

}  // namespace
}  // namespace hapticut::openvdb_test
