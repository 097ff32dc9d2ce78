// SPDX-License-Identifier: Apache-2.0
// Heat on its way from the steps to the field: what is handed on, where it is put, and what comes of it.
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

Simulation bone_drilling() {
  Workpiece block = build_block({Vec3(-4, -4, -5) * mm, Vec3(4, 4, 0) * mm}, 0.1 * mm, presets::cortical_bone());
  SimulationConfig config;
  config.reserved_blocks = 1000;
  return Simulation(std::move(block), Tool(SphereHead{1 * mm}, RayHandle{0}, Spindle{3000 * units::rad_per_s}), config);
}

/// A ball drills down at 0.2 mm/s: heat is as fast over a millimetre of bone.
const StepResult& drill(Simulation& simulation, int tick) {
  const double speed = 0.2 * mm, dt = 5 * ms, z = 1 * mm - speed * tick * dt;
  return simulation.step(Pose::from_translation({0.013 * mm, 0.021 * mm, z}), {{0, 0, -speed}, Vec3::Zero()}, dt);
}

struct Drilled {
  HeatField field;
  EnergyLedger energy;
};
Drilled drill(HeatConfig config, const HeatCollectorOptions& options = {}) {
  Simulation simulation = bone_drilling();
  HeatCollector collector(simulation, options);
  HeatField field(simulation.workpiece(), std::move(config));
  for (int tick = 1; tick <= kDown; ++tick) {
    (void)drill(simulation, tick);
    if (tick % 10 == 0) field.advance(field.take(collector));
  }
  return {std::move(field), simulation.last_result().energy};
}

double stays(const EnergyLedger& e) { return 0.2 * e.losses(); }

TEST(HeatCollector, BringsTheSharesOfTheLedgerToTheField) {
  const Drilled drilled = drill({});
  const HeatBalance balance = drilled.field.balance();
  EXPECT_GT(balance.brought_in, 0.1);
  EXPECT_NEAR(balance.brought_in, stays(drilled.energy), 1e-9 * balance.brought_in);
  EXPECT_LT(std::abs(balance.imbalance()), 1e-9 * balance.brought_in);
  EXPECT_GT(balance.chips, 0);
}

TEST(HeatCollector, LosesNothingWhereItsQueuesAreFull) {
  HeatCollectorOptions tight;
  tight.pulses = 3;
  tight.blocks.block_capacity = 2;
  tight.blocks.blocks_per_step = 1;
  Simulation simulation = bone_drilling();
  HeatCollector collector(simulation, tight);
  HeatField field(simulation.workpiece());
  for (int tick = 1; tick <= kDown; ++tick) {
    (void)drill(simulation, tick);
    if (tick % 10 == 0) field.advance(field.take(collector));
  }
  double time = 0;
  for (int tick = 0; tick < 400; ++tick) {  // the spindle stands, the rest comes out
    simulation.halt_spindle();
    (void)simulation.step(Pose::from_translation({0, 0, 10 * mm}), {}, 1 * ms);
    time += field.take(collector);
  }
  field.advance(time);
  EXPECT_NEAR(field.balance().brought_in, stays(simulation.last_result().energy), 1e-9);
  const HeatField known(simulation.workpiece());
  for (int z = 0; z < known.dims()[2]; ++z)
    for (int x = 0; x < known.dims()[0]; ++x) {
      const std::array<int, 3> cell = {x, known.dims()[1] / 2, z};
      EXPECT_EQ(std::isnan(known.temperature(cell)), std::isnan(field.temperature(cell)));
    }
}

TEST(HeatField, IsWarmestAtTheGroundOfTheHoleAndCoolerUnderWater) {
  HeatConfig wet;
  wet.irrigation = 3000;
  wet.water_temperature = 37;
  const Drilled dry = drill({}), cooled = drill(wet);
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
  const Drilled coarse = drill({}), finer = drill(fine);
  // What leaves with the chips is the heat of the layer that goes, which is warmer the thinner it is seen.
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
  Workpiece block = build_block({Vec3(-4, -4, -5) * mm, Vec3(4, 4, 0) * mm}, 0.1 * mm, presets::cortical_bone());
  SimulationConfig config;
  config.removal = RemovalLaw::none;
  Simulation simulation(std::move(block),
                        Tool(FlatHead{1 * mm, 3 * mm}, RayHandle{0}, Spindle{3000 * units::rad_per_s}), config);
  HeatCollector collector(simulation);
  HeatField field(simulation.workpiece());
  for (int tick = 0; tick < 500; ++tick) {
    (void)simulation.step(Pose::from_translation({1 * mm, 0.5 * mm, -0.0005 * mm}), {}, 1 * ms);
    if (tick % 50 == 0) field.advance(field.take(collector));
  }
  field.advance(field.take(collector));
  EXPECT_NEAR(field.balance().brought_in, 0.2 * simulation.last_result().energy.rubbing, 1e-9);
  EXPECT_GT(field.balance().brought_in, 0);
  // All over the face of the head, not in one point of it.
  const auto rise_at = [&](double x, double y) { return field.temperature_at(Vec3(x, y, -0.2) * mm) - 37; };
  EXPECT_GT(rise_at(1.4, 0.5), 0.5 * rise_at(1, 0.5));
  EXPECT_LT(rise_at(2.8, 0.5), 0.1 * rise_at(1, 0.5));
}

TEST(HeatCollector, CountsWhatCrushingTakes) {
  Simulation block(build_block({Vec3(-2, -2, -2) * mm, Vec3(2, 2, 0) * mm}, 0.1 * mm, presets::clay()),
                   Tool(SphereHead{1 * mm}, RayHandle{0}, Spindle{0}));
  HeatCollector collector(block);
  HeatField field(block.workpiece());
  for (int tick = 1; tick <= 100; ++tick)
    (void)block.step(Pose::from_translation({0, 0, (1 - 0.005 * tick) * mm}), {}, 1 * ms);
  field.advance(field.take(collector));
  const EnergyLedger& energy = block.last_result().energy;
  ASSERT_GT(energy.crushed, 0.5 * energy.losses());
  EXPECT_NEAR(field.balance().brought_in / stays(energy), 1, 1e-9);
}

TEST(HeatCollector, HandsItsHeatToAnotherThread) {
  Simulation simulation = bone_drilling();
  HeatCollector collector(simulation);
  HeatField field(simulation.workpiece());
  std::atomic<bool> done = false;
  std::thread beside([&] {
    while (!done) {
      field.advance(field.take(collector));
      std::this_thread::yield();
    }
    field.advance(field.take(collector));
  });
  for (int tick = 1; tick <= kDown; ++tick) (void)drill(simulation, tick);
  simulation.halt_spindle();
  for (int tick = 0; tick < 100; ++tick) (void)simulation.step(Pose::from_translation({0, 0, 10 * mm}), {}, 1 * ms);
  done = true;
  beside.join();
  EXPECT_NEAR(field.balance().brought_in, stays(simulation.last_result().energy), 1e-9);
}

TEST(HeatCollector, GoesOnAfterAnUndoWithMaterialThatIsBack) {
  Simulation simulation = bone_drilling();
  simulation.reserve_undo(500);
  HeatCollector collector(simulation);
  HeatField field(simulation.workpiece());
  simulation.set_undo_mark();
  for (int tick = 1; tick <= kDown; ++tick) {
    (void)drill(simulation, tick);
    field.advance(field.take(collector));
  }
  const Vec3 in_hole = Vec3(0, 0, -0.6) * mm;
  EXPECT_TRUE(std::isnan(field.temperature_at(in_hole)));
  while (!simulation.undo(64)) {
  }
  for (int tick = 0; tick < 400; ++tick) {
    (void)simulation.step(Pose::from_translation({0, 0, 10 * mm}), {}, 1 * ms);
    field.advance(field.take(collector));
  }
  EXPECT_FALSE(std::isnan(field.temperature_at(in_hole)));
  EXPECT_LT(std::abs(field.balance().imbalance()), 1e-9 * field.balance().brought_in);
}

TEST(TouchingPoint, IsWhereTheForceComesFrom) {
  const ToolHead ball = SphereHead{1 * mm};
  EXPECT_TRUE(touching_point(ball, {{0, 0, 3}, Vec3::Zero()}).isApprox(Vec3(0, 0, -1) * mm, 1e-4));
  EXPECT_TRUE(touching_point(ball, {{-2, 0, 0}, Vec3::Zero()}).isApprox(Vec3(1, 0, 0) * mm, 1e-3));
  // A cylinder that is pushed aside 3 mm above its end.
  const ToolHead cylinder = FlatHead{1 * mm, 4 * mm};
  const Vec3 at = Vec3(1, 0, 3) * mm, force(-2, 0, 0);
  EXPECT_TRUE(touching_point(cylinder, {force, at.cross(force)}).isApprox(at, 1e-3));
  EXPECT_TRUE(touching_point(cylinder, {{0, 0, 1}, Vec3::Zero()}).isApprox(Vec3::Zero(), 1e-3) ||
              touching_point(cylinder, {{0, 0, 1}, Vec3::Zero()}).norm() < 1e-5);
  EXPECT_EQ(touching_point(ball, {}), Vec3::Zero());
}

}  // namespace
}  // namespace hapticut::heat_collector_test
