// SPDX-License-Identifier: Apache-2.0
// Heat from the steps to the field: what is passed on, where it is added, and the resulting temperatures.
#include "hapticut/heat/heat_collector.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <atomic>
#include <cmath>
#include <thread>

#include "hapticut/core/units.hpp"
#include "hapticut/heat/heat_field.hpp"
#include "hapticut/simulation/simulation.hpp"
#include "hapticut/workpiece/builders.hpp"
#include "hapticut/workpiece/material_presets.hpp"

namespace hapticut::heat_collector_test {
namespace {

using units::mm;
using units::ms;

constexpr int kDown = 1500;

Simulation bone_under(const ToolHead& head, RemovalLaw removal = RemovalLaw::constant_energy) {
  SimulationConfig config;
  config.reserved_blocks = 1000;
  config.removal = removal;
  return Simulation(build_block({Vec3(-4, -4, -5) * mm, Vec3(4, 4, 0) * mm}, 0.1 * mm, presets::cortical_bone()),
                    Tool(head, RayHandle{0}, Spindle{3000 * units::rad_per_s}), config);
}

/// A ball that drills into bone at 0.2 mm/s, about the speed of heat over a millimetre, and the heat field of the bone.
struct Drilling {
  explicit Drilling(HeatConfig config = {}, const HeatCollectorOptions& options = {})
      : collector(simulation, options), field(simulation.workpiece(), with_share(std::move(config))) {}
  static HeatConfig with_share(HeatConfig config) {
    config.cutting_share = 0.2;
    return config;
  }

  void down_one_tick(int tick) {
    const double speed = 0.2 * mm, dt = 5 * ms, z = 1 * mm - speed * tick * dt;
    (void)simulation.step(Pose::from_translation({0.013 * mm, 0.021 * mm, z}), {{0, 0, -speed}, Vec3::Zero()}, dt);
  }
  void down(int ticks_between_looks = 10) {
    for (int tick = 1; tick <= kDown; ++tick) {
      down_one_tick(tick);
      if (tick % ticks_between_looks == 0) update();
    }
  }
  void stay_in_the_air() { (void)simulation.step(Pose::from_translation({0, 0, 10 * mm}), {}, 1 * ms); }
  void update() { field.advance(field.drain(collector)); }
  /// [J] part of the heat of all steps that stays in the workpiece
  [[nodiscard]] double stays() const { return 0.2 * simulation.last_result().energy.losses(); }

  Simulation simulation = bone_under(SphereHead{1 * mm});
  HeatCollector collector;
  HeatField field;
};

TEST(HeatCollector, BringsTheSharesOfTheLedgerToTheField) {
  Drilling drilling;
  drilling.down();
  const HeatBalance balance = drilling.field.balance();
  EXPECT_GT(balance.brought_in, 0.1);
  EXPECT_NEAR(balance.brought_in, drilling.stays(), 1e-9 * balance.brought_in);
  EXPECT_LT(std::abs(balance.imbalance()), 1e-9 * balance.brought_in);
  EXPECT_LT(balance.chips, 0.003 * balance.brought_in) << "what chips take is in the share, once";
}

TEST(HeatCollector, TakesTheShareOfTheCutter) {
  const auto brought_in = [](CutterKind kind) {
    Simulation simulation(
        build_block({Vec3(-2, -2, -2) * mm, Vec3(2, 2, 0) * mm}, 0.1 * mm, presets::cortical_bone(kind)),
        Tool(SphereHead{1 * mm}, RayHandle{0}, Spindle{3000 * units::rad_per_s}, Cutter{kind}), {});
    HeatCollector collector(simulation);
    HeatField field(simulation.workpiece());
    for (int tick = 0; tick < 300; ++tick)
      (void)simulation.step(Pose::from_translation({0.013 * mm, 0.021 * mm, 1 * mm - 1e-6 * tick}), {}, 5 * ms);
    (void)field.drain(collector);
    return field.balance().brought_in / simulation.last_result().energy.losses();
  };
  EXPECT_EQ(heat_share_of(CutterKind::coarse_diamond), 0.05);
  for (const auto& kind : names_of(Of<CutterKind>{}))
    EXPECT_NEAR(brought_in(kind.value), heat_share_of(kind.value), 0.02 * heat_share_of(kind.value)) << kind.name;
}

TEST(HeatField, LosesTheHeatOfALoosePieceButNotThatOfACut) {
  Drilling drilling;
  drilling.down();
  const HeatBalance before = drilling.field.balance();
  ASSERT_LT(before.chips, 0.003 * before.stored);
  BlockVoxels piece;
  piece.origin = {0, 0, -16};  // beside the hole
  for (int voxel = 0; voxel < kBlockVoxels; ++voxel) piece.voxels.add(voxel);
  drilling.simulation.spindle().halt();
  ASSERT_TRUE(drilling.simulation.remove_voxels(piece));
  for (int tick = 0; tick < 10; ++tick) drilling.stay_in_the_air();
  drilling.update();
  const HeatBalance balance = drilling.field.balance();
  EXPECT_GT(balance.chips, before.chips + 1e-4 * before.stored);
  EXPECT_LT(std::abs(balance.imbalance()), 1e-9 * balance.brought_in);
}

TEST(HeatCollector, LosesNothingWhereItsQueuesAreFull) {
  HeatCollectorOptions tight;
  tight.pulses = 3;
  tight.blocks.block_capacity = 2;
  tight.blocks.blocks_per_step = 1;
  Drilling drilling({}, tight);
  drilling.down();
  double time = 0;
  for (int tick = 0; tick < 400; ++tick) {  // the cut has ended; the field receives the remaining heat
    drilling.simulation.spindle().halt();
    drilling.stay_in_the_air();
    time += drilling.field.drain(drilling.collector);
  }
  drilling.field.advance(time);
  EXPECT_NEAR(drilling.field.balance().brought_in, drilling.stays(), 1e-9);
  const HeatField known(drilling.simulation.workpiece());
  for (int z = 0; z < known.dims()[2]; ++z)
    for (int x = 0; x < known.dims()[0]; ++x) {
      const std::array<int, 3> cell = {x, known.dims()[1] / 2, z};
      EXPECT_EQ(std::isnan(known.temperature(cell)), std::isnan(drilling.field.temperature(cell)));
    }
}

TEST(HeatField, IsWarmestAtTheGroundOfTheHoleAndCoolerUnderWater) {
  HeatConfig wet;
  wet.irrigation = 3000;
  wet.water_temperature = 37;
  Drilling dry, cooled(wet);
  dry.down();
  cooled.down();
  const Vec3 below = Vec3(0, 0, -2.0) * mm, beside = Vec3(2.5, 0, -0.5) * mm;
  EXPECT_GT(dry.field.temperature_at(below), 38);
  EXPECT_GT(dry.field.temperature_at(below), dry.field.temperature_at(beside) + 1);
  EXPECT_LT(cooled.field.structures()[0].peak, dry.field.structures()[0].peak);
  EXPECT_LT(cooled.field.structures()[0].temperature, dry.field.structures()[0].temperature);
  EXPECT_LT(cooled.field.structures()[0].cem43, dry.field.structures()[0].cem43);
  EXPECT_GT(cooled.field.balance().irrigation, 0);
}

TEST(HeatField, IsNearlyTheSameOnCellsOfHalfTheSize) {
  HeatConfig fine;
  fine.voxels_per_cell = 2;
  Drilling coarse, finer(fine);
  coarse.down();
  finer.down();
  EXPECT_NEAR(coarse.field.balance().stored / finer.field.balance().stored, 1, 0.05);
  EXPECT_NEAR((coarse.field.structures()[0].peak - 37) / (finer.field.structures()[0].peak - 37), 1, 0.35)
      << coarse.field.structures()[0].peak << " and " << finer.field.structures()[0].peak;
  for (const double z : {-2.0, -2.5, -3.0}) {
    const Vec3 below = Vec3(0, 0, z) * mm;
    const double rise = finer.field.temperature_at(below) - 37;
    EXPECT_NEAR((coarse.field.temperature_at(below) - 37) / rise, 1, 0.15) << rise << " K at " << z << " m";
  }
}

TEST(HeatField, TakesTheHeatOfAHeadThatOnlyRubsWhereItTouches) {
  Simulation simulation = bone_under(FlatHead{1 * mm, 3 * mm}, RemovalLaw::none);
  HeatCollector collector(simulation);
  HeatField field(simulation.workpiece());
  for (int tick = 0; tick < 500; ++tick) {
    (void)simulation.step(Pose::from_translation({1 * mm, 0.5 * mm, -0.0005 * mm}), {}, 1 * ms);
    if (tick % 50 == 0) field.advance(field.drain(collector));
  }
  field.advance(field.drain(collector));
  EXPECT_NEAR(field.balance().brought_in, 0.2 * simulation.last_result().energy.rubbing, 1e-9);
  EXPECT_GT(field.balance().brought_in, 0);
  // The heat enters over the whole face of the head, not at one point.
  const auto rise_at = [&](double x, double y) { return field.temperature_at(Vec3(x, y, -0.2) * mm) - 37; };
  EXPECT_GT(rise_at(1.4, 0.5), 0.5 * rise_at(1, 0.5));
  EXPECT_LT(rise_at(2.8, 0.5), 0.1 * rise_at(1, 0.5));
}

TEST(HeatCollector, HandsItsHeatToAnotherThread) {
  Drilling drilling;
  std::atomic<bool> done = false;
  std::thread beside([&] {
    while (!done) {
      drilling.update();
      std::this_thread::yield();
    }
    drilling.update();
  });
  for (int tick = 1; tick <= kDown; ++tick) drilling.down_one_tick(tick);
  drilling.simulation.spindle().halt();
  for (int tick = 0; tick < 100; ++tick) drilling.stay_in_the_air();
  done = true;
  beside.join();
  EXPECT_NEAR(drilling.field.balance().brought_in, drilling.stays(), 1e-9);
}

TEST(HeatCollector, ContinuesAfterAnUndoWithRestoredMaterial) {
  Drilling drilling;
  drilling.simulation.history().reserve(500);
  drilling.simulation.history().mark();
  drilling.down(1);
  const Vec3 in_hole = Vec3(0, 0, -0.6) * mm;
  EXPECT_TRUE(std::isnan(drilling.field.temperature_at(in_hole)));
  while (!drilling.simulation.history().undo(64)) {
  }
  for (int tick = 0; tick < 400; ++tick) {
    drilling.stay_in_the_air();
    drilling.update();
  }
  EXPECT_FALSE(std::isnan(drilling.field.temperature_at(in_hole)));
  const HeatBalance balance = drilling.field.balance();
  EXPECT_LT(std::abs(balance.imbalance()), 1e-9 * balance.brought_in);
}

TEST(TouchingPoint, IsWhereTheForceComesFrom) {
  const ToolHead ball = SphereHead{1 * mm};
  EXPECT_TRUE(touching_point(ball, {{0, 0, 3}, Vec3::Zero()}).isApprox(Vec3(0, 0, -1) * mm, 1e-4));
  EXPECT_TRUE(touching_point(ball, {{-2, 0, 0}, Vec3::Zero()}).isApprox(Vec3(1, 0, 0) * mm, 1e-3));
  // A cylinder with a lateral force 3 mm above its end.
  const ToolHead cylinder = FlatHead{1 * mm, 4 * mm};
  const Vec3 at = Vec3(1, 0, 3) * mm, force(-2, 0, 0);
  EXPECT_TRUE(touching_point(cylinder, {force, at.cross(force)}).isApprox(at, 1e-3));
  EXPECT_TRUE(touching_point(cylinder, {{0, 0, 1}, Vec3::Zero()}).isApprox(Vec3::Zero(), 1e-3) ||
              touching_point(cylinder, {{0, 0, 1}, Vec3::Zero()}).norm() < 1e-5);
  EXPECT_EQ(touching_point(ball, {}), Vec3::Zero());
}

}  // namespace
}  // namespace hapticut::heat_collector_test
