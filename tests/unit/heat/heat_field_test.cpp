// SPDX-License-Identifier: Apache-2.0
// Heat that spreads in a workpiece, against closed forms and its own balance.
#include "hapticut/heat/heat_field.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <map>
#include <vector>

#include "hapticut/core/units.hpp"
#include "hapticut/workpiece/builders.hpp"
#include "hapticut/workpiece/material_presets.hpp"
#include "support/workpieces.hpp"

namespace hapticut::heat_field_test {
namespace {

using units::kPi;
using units::mm;

constexpr ThermalProperties kBone;

double diffusivity() { return kBone.conductivity / kBone.heat_capacity; }

/// A block of whole cells around the origin of W, which is in the middle of a cell.
HeatField block_field(const Vec3& half_size, double cell, HeatConfig config = {}) {
  config.voxels_per_cell = 8;
  const double voxel = cell / 8;
  const Vec3 odd = Vec3::Constant(cell / 2);
  return HeatField(build_block({-half_size - odd, half_size + odd}, voxel, test::named("bone")), config);
}

/// [K] Maximum error of an instantaneous point source after 8 s, relative to the middle.
double error_of_point_source(double cell) {
  constexpr double kHeat = 0.5, kTime = 8;
  HeatField field = block_field(Vec3::Constant(8 * mm), cell);
  field.add_heat(Vec3::Zero(), kHeat);
  for (int n = 0; n < 80; ++n) field.advance(kTime / 80);
  const double spread = 4 * diffusivity() * kTime;
  const double middle = kHeat / (kBone.heat_capacity * std::pow(kPi * spread, 1.5));
  double worst = 0;
  for (int r = 0; r <= 4; ++r) {
    const Vec3 p = Vec3(1, 0, 0) * (r * mm);
    const double rise = field.temperature_at(p) - 37;
    worst = std::max(worst, std::abs(rise - middle * std::exp(-p.squaredNorm() / spread)) / middle);
  }
  return worst;
}

TEST(HeatField, SpreadsAPointSourceAsTheClosedFormAtSecondOrderInTheCell) {
  const double coarse = error_of_point_source(1 * mm), fine = error_of_point_source(0.5 * mm);
  RecordProperty("coarse", std::to_string(coarse));
  RecordProperty("fine", std::to_string(fine));
  EXPECT_LT(fine, 0.01);
  EXPECT_GT(std::log2(coarse / fine), 1.8) << coarse << " to " << fine;
}

TEST(HeatField, TrailsAMovingLineSourceAsJaegersClosedForm) {
  // In a plate one cell thick the source is a line. Far from the ends of the plate and long after the start, the field
  // moves with the source.
  constexpr double kCell = 0.25 * mm, kSpeed = 0.25 * mm, kPower = 0.05, kTime = 60, kTick = 0.02;
  HeatConfig config;
  config.voxels_per_cell = 8;
  HeatField field(build_block({Vec3(-16, -12, 0) * mm, Vec3(16, 12, kCell / mm) * mm}, kCell / 8, test::named("bone")),
                  config);
  const double begin = -9 * mm, per_length = kPower / kCell;
  const int ticks = int(std::lround(kTime / kTick));
  for (int n = 0; n < ticks; ++n) {
    field.add_heat({begin + kSpeed * kTick * (n + 0.5), 0.1 * mm, kCell / 2}, kPower * kTick);
    field.advance(kTick);
  }
  const double head = begin + kSpeed * kTime, a = diffusivity();
  // Ahead the field falls by a factor of e in 2.6 cells: interpolation has an error of 2 %, the width of the source of
  // 1 %, and the tick, whose heat comes at its beginning, of 1 %.
  const std::pair<Vec3, double> places[] = {
      {{-4, 0, 0}, 0.015}, {{-2, 1, 0}, 0.015}, {{-1, -1, 0}, 0.015}, {{0, 1.5, 0}, 0.015}, {{1, 0, 0}, 0.05}};
  for (const auto& [from, tolerance] : places) {
    const Vec3 p = from * mm;
    // The coordinate is positive ahead of the source.
    const double expected = per_length / (2 * kPi * kBone.conductivity) * std::exp(-kSpeed * p.x() / (2 * a)) *
                            std::cyl_bessel_k(0.0, kSpeed * p.norm() / (2 * a));
    const double rise = field.temperature_at({head + p.x(), 0.1 * mm + p.y(), kCell / 2}) - 37;
    EXPECT_NEAR(rise / expected, 1, tolerance)
        << "at " << from.transpose() << " mm: " << rise << " K, not " << expected;
  }
}

/// [m^2] Wetted surface: the initial heat flow from a body 1 K warmer, through a film with a dominant resistance.
double wetted_area(const Workpiece& workpiece) {
  HeatConfig config;
  config.water_temperature = config.body_temperature - 1;
  config.irrigation = 0.1;
  HeatField field(workpiece, config);
  field.advance(1e-3);
  return field.balance().irrigation / (config.irrigation * 1e-3);
}

TEST(HeatField, MeasuresTheSurfaceOfABody) {
  // Cells of 0.4 mm. The area of a plate's faces is exact. At an edge of two faces the diagonal across the edge counts.
  const double ball =
      wetted_area(build_sphere({0.03 * mm, 0.01 * mm, 0.02 * mm}, 3 * mm, 0.1 * mm, test::named("bone")));
  EXPECT_NEAR(ball / (4 * kPi * 9e-6), 1, 0.03);
  const double plate =
      wetted_area(build_block({Vec3(0, 0, 0) * mm, Vec3(32, 32, 0.8) * mm}, 0.1 * mm, test::named("bone")));
  EXPECT_NEAR(plate / (2 * 32 * 32 * 1e-6), 1, 0.03);
}

TEST(HeatField, IsCooledByWaterAsAPlateIs) {
  // The plate is so thin (Biot number 0.015) that it cools uniformly: exp(-2 h t/(rho c d)).
  HeatConfig config;
  config.body_temperature = 60;
  config.water_temperature = 20;
  config.irrigation = 20;
  HeatField field(build_block({Vec3(0, 0, 0) * mm, Vec3(32, 32, 0.8) * mm}, 0.1 * mm, test::named("bone")), config);
  field.advance(40);
  const double expected = 20 + 40 * std::exp(-2 * 20 * 40 / (kBone.heat_capacity * 0.8 * mm));
  EXPECT_NEAR(field.temperature_at(Vec3(16, 16, 0.4) * mm), expected, 0.005 * 40);
}

TEST(HeatField, KeepsItsBalanceWhileMaterialGoesAndWaterFlows) {
  HeatConfig config;
  config.irrigation = 2000;
  config.voxels_per_cell = 2;
  std::vector<Layer> layers = {{presets::enamel(), 1 * mm}, {presets::dentin(), 3 * mm}};
  Workpiece slab = build_layered_slab({Vec3(-3, -3, -4) * mm, Vec3(3, 3, 0) * mm}, 0.2 * mm, layers);
  config.by_material = {{0.93, 2.0e6}, {0.58, 3.1e6}};
  HeatField field(slab, config);
  slab.reserve_blocks(100);
  for (int n = 0; n < 200; ++n) {
    const Vec3 p = Vec3(2 * std::sin(0.1 * n), 2 * std::cos(0.13 * n), -1.5) * mm;
    field.add_heat(p, 1e-3);
    const VoxelIndex at = {n % 30, n * 7 % 30, n * 3 % 20},
                     origin = {block_start(at[0]), block_start(at[1]), block_start(at[2])};
    if (float* fill = slab.writable_fill(origin)) {
      const int voxel = block_offset(at[0] & 7, at[1] & 7, at[2] & 7);
      fill[voxel] *= 0.3F;
      if (n % 3 == 0) {
        BlockMask emptied;
        emptied.add(voxel);
        slab.empty_voxels(origin, emptied);
      }
      field.update(slab, {&origin, 1});
      field.add_cutting_heat(2e-3);
    }
    field.advance(0.05);
    const HeatBalance balance = field.balance();
    ASSERT_LT(std::abs(balance.imbalance()), 1e-9 * (balance.brought_in + std::abs(balance.irrigation)));
  }
  EXPECT_NEAR(field.balance().brought_in, 200 * 3e-3, 1e-12);
  EXPECT_LT(std::abs(field.balance().chips), 1e-3 * field.balance().brought_in);
}

/// [deg C] Maximum while a square of 2 mm is cut out of enamel at 0.2 mm/s, down to 1.2 mm, dry: 1250 J/cm^3 stay.
double peak_of_a_pit(double thickness) {
  constexpr double kSpeed = 0.2 * mm, kHeatPerVolume = 1.25e9, kVoxel = 0.1 * mm;
  constexpr int kParts = 4, kWide = 10;  // parts of a slice, [voxels] half of the square
  Workpiece plate =
      build_block({Vec3(-4 * mm, -4 * mm, -thickness), Vec3(4 * mm, 4 * mm, 0)}, kVoxel, test::named("enamel"));
  plate.reserve_blocks(1000);
  HeatField field(plate);
  const IndexBox all = plate.bounds();
  const int middle = (all.min[0] + all.max[0]) / 2;
  for (int n = 0; n < 12 * kParts; ++n) {
    std::map<VoxelIndex, BlockMask> square;
    for (int x = middle - kWide; x < middle + kWide; ++x)
      for (int y = middle - kWide; y < middle + kWide; ++y) {
        const VoxelIndex at = {x, y, all.max[2] - n / kParts};
        square[{block_start(x), block_start(y), block_start(at[2])}].add(block_offset(x & 7, y & 7, at[2] & 7));
      }
    std::vector<VoxelIndex> origins;
    for (const auto& [origin, mask] : square) {
      float* fill = plate.writable_fill(origin);
      mask.for_each([&](int voxel) { fill[voxel] -= 1.0F / kParts; });
      if (n % kParts == kParts - 1) plate.empty_voxels(origin, mask);
      origins.push_back(origin);
    }
    field.update(plate, origins);
    field.add_cutting_heat(kHeatPerVolume * 4 * kWide * kWide * std::pow(kVoxel, 3) / kParts);
    field.advance(kVoxel / kParts / kSpeed);
  }
  const HeatBalance balance = field.balance();
  EXPECT_LT(std::abs(balance.imbalance()), 1e-9 * balance.brought_in);
  EXPECT_LT(balance.chips, 0.05 * balance.brought_in);
  return field.warmest()->temperature;
}

TEST(HeatField, LeavesTheHeatOfTheLastOfAThinWallToTheChips) {
  const double in_a_block = peak_of_a_pit(6 * mm), through_a_plate = peak_of_a_pit(1.2 * mm);
  EXPECT_NEAR(in_a_block, 300, 30);
  EXPECT_LT(through_a_plate, 3 * in_a_block);  // six times with all of the heat in what is left
}

TEST(HeatField, CountsEquivalentMinutesAt43) {
  EXPECT_DOUBLE_EQ(cem43(43, 60), 1);
  EXPECT_DOUBLE_EQ(cem43(44, 60), 2);
  EXPECT_DOUBLE_EQ(cem43(47, 90), 1.5 * 16);
  EXPECT_DOUBLE_EQ(cem43(42, 60), 0.25);
  EXPECT_DOUBLE_EQ(cem43(41, 240), 0.25);
  // 2 min at 42, 30 s at 45, 1 min at 47.5 deg C: 0.5 + 2 + 22.63 min.
  HeatConfig config;
  config.body_temperature = 42;
  HeatField field = block_field(Vec3::Zero(), 1 * mm, config);  // a single cell
  const auto warm = [&](double rise) { field.add_heat(Vec3::Zero(), rise * kBone.heat_capacity * 1e-9); };
  field.advance(120);
  warm(3);
  field.advance(30);
  warm(2.5);
  field.advance(60);
  const StructureHeat heat = field.structures().at(0);
  EXPECT_NEAR(heat.cem43, 0.5 + 2 + std::exp2(4.5), 1e-9);
  EXPECT_NEAR(heat.time_above, 60, 1e-9);
  EXPECT_NEAR(heat.temperature, 47.5, 1e-9);
  EXPECT_NEAR(heat.peak, 47.5, 1e-9);
  EXPECT_NEAR(heat.volume_above, 1e-9, 1e-15);
}

TEST(HeatField, ReportsByMaterialAndForgetsTheTimeOfWhatIsGone) {
  std::vector<Layer> layers = {{presets::enamel(), 0.8 * mm}, {presets::dentin(), 0.8 * mm}};
  Workpiece slab = build_layered_slab({Vec3(-2, -2, -1.6) * mm, Vec3(2, 2, 0) * mm}, 0.1 * mm, layers);
  slab.reserve_blocks(1000);
  HeatField field(slab);
  field.add_heat(Vec3(0.2, 0.2, -0.2) * mm, 0.02);
  for (int n = 0; n < 20; ++n) field.advance(0.05);
  const std::vector<StructureHeat> hot = field.structures();
  ASSERT_EQ(hot.size(), 2U);
  EXPECT_GT(hot[0].peak, hot[1].peak);
  EXPECT_GT(hot[1].peak, 37.1);
  EXPECT_GT(hot[0].time_above, 0);
  EXPECT_GT(hot[0].volume_above, 0);
  // All enamel is removed.
  std::vector<VoxelIndex> origins;
  slab.for_each_block([&](const BlockView& block) { origins.push_back(block.origin); });
  const MaterialId enamel = slab.materials().id_of(presets::enamel().name);
  for (const VoxelIndex& origin : origins) {
    BlockMask emptied;
    for (int n = 0; n < kBlockVoxels; ++n)
      if (slab.material_at(voxel_at(origin, n)) == enamel) emptied.add(n);
    ASSERT_NE(slab.writable_fill(origin), nullptr);
    slab.empty_voxels(origin, emptied);
  }
  field.update(slab, origins);
  field.advance(0.05);
  const std::vector<StructureHeat> left = field.structures();
  EXPECT_EQ(left[0].temperature, 37);
  EXPECT_EQ(left[0].time_above, 0);
  EXPECT_EQ(left[0].volume_above, 0);
  EXPECT_EQ(left[0].peak, hot[0].peak);
  EXPECT_GT(field.balance().chips, 0);
  EXPECT_TRUE(std::isnan(field.temperature_at(Vec3(0.2, 0.2, -0.2) * mm)));
}

TEST(HeatField, RefusesWhatItCannotDo) {
  HeatConfig config;
  config.voxels_per_cell = 3;
  EXPECT_THROW(HeatField(build_block({Vec3::Zero(), Vec3::Constant(1 * mm)}, 0.1 * mm, test::named("bone")), config),
               Error);
  config = {};
  config.by_material = {{-1, 1e6}};
  EXPECT_THROW(HeatField(build_block({Vec3::Zero(), Vec3::Constant(1 * mm)}, 0.1 * mm, test::named("bone")), config),
               Error);
  HeatField field(build_block({Vec3::Zero(), Vec3::Constant(1 * mm)}, 0.1 * mm, test::named("bone")));
  EXPECT_THROW(field.advance(-1), Error);
  EXPECT_THROW(field.set_irrigation(-1), Error);
}

}  // namespace
}  // namespace hapticut::heat_field_test
