// SPDX-License-Identifier: Apache-2.0
// Exchanges between two steps: tool, materials, friction, removal, workpiece.
#include "hapticut/simulation/exchange.hpp"

#include <gtest/gtest.h>

#include <string>
#include <utility>

#include "experiments/setup/cutting.hpp"
#include "hapticut/core/errors.hpp"
#include "hapticut/force/laws/twist_drill.hpp"
#include "hapticut/tool/catalogue.hpp"
#include "hapticut/workpiece/builders.hpp"

namespace hapticut::exchange_test {
namespace {

constexpr double kStep = 1e-3;  // [s]

SimulationConfig config() {
  SimulationConfig config;
  config.reference_stiffness = 1e13;
  config.reserved_blocks = 4096;
  return config;
}
Material material(double energy, const std::string& name = "plain") {
  Material m = test::plain_material();
  m.name = name;
  m.specific_cutting_energy = energy;
  return m;
}
Workpiece block(double voxel = 2e-4) {
  return build_block({Vec3(-6e-3, -6e-3, -6e-3), Vec3(6e-3, 6e-3, 0)}, voxel, material(3e8));
}
Tool ball(double radius, double speed = 3000) {
  return Tool(SphereHead{radius}, RayHandle{0}, Spindle{speed * units::rad_per_s});
}

/// Feeds a ball down by 1 mm from its first contact.  @return the last force
Vec3 drill(Simulation& simulation, double radius, double x = 0) {
  Vec3 force;
  for (int n = 0; n < 100; ++n)
    force =
        simulation.step(Pose::from_translation({x, 0, radius - 1e-5 * n}), {{0, 0, -1e-2}, Vec3::Zero()}, kStep).force;
  return force;
}

TEST(SetTool, KeepsTheWorkpieceAndAllThatWasCounted) {
  Simulation simulation(block(), ball(1e-3), config());
  simulation.history().reserve(1000);
  simulation.history().mark();
  drill(simulation, 1e-3);
  const std::uint64_t cut = simulation.workpiece().hash(), steps = simulation.steps();
  const double removed = simulation.totals().removed_volume[1], spent = simulation.last_result().energy.cutting;
  ASSERT_GT(removed, 0);
  simulation.set(ball(2e-3, 1000));
  EXPECT_EQ(simulation.workpiece().hash(), cut);
  EXPECT_EQ(simulation.totals().removed_volume[1], removed);
  EXPECT_EQ(simulation.last_result().energy.cutting, spent);
  EXPECT_EQ(simulation.steps(), steps);
  EXPECT_EQ(simulation.workpiece().marks(), 1U);
  EXPECT_EQ(simulation.spindle().setting(), 1000);
  EXPECT_EQ(simulation.totals().exchanges, 1U) << "a recording ends here";
  EXPECT_EQ(std::get<SphereHead>(simulation.tool().head().shape()).radius, 2e-3);
  EXPECT_TRUE(simulation.last_result().removed_voxels.empty());
  EXPECT_TRUE(simulation.changed_blocks().origins.empty());
}

TEST(SetTool, MakesTheSimulationThatItWouldHaveBeenWithThisTool) {
  // Tools smaller and larger than the first one. Lists, bounds and the default stiffness follow the new tool.
  for (const auto& [radius, stiffness] : {std::pair(0.5e-3, 1e13), {2.5e-3, 1e13}, {2.5e-3, 0.0}}) {
    SimulationConfig of_stiffness = config();
    of_stiffness.reference_stiffness = stiffness;
    Simulation with(block(), ball(radius), of_stiffness);
    Simulation changed(block(), ball(1e-3), of_stiffness);
    changed.set(ball(radius));
    EXPECT_EQ(changed.config().reference_stiffness, with.config().reference_stiffness);
    EXPECT_EQ(changed.worst_case().voxels, with.worst_case().voxels);
    EXPECT_EQ(changed.worst_case().blocks, with.worst_case().blocks);
    EXPECT_EQ(drill(changed, radius), drill(with, radius));
    EXPECT_EQ(changed.workpiece().hash(), with.workpiece().hash());
    EXPECT_EQ(changed.last_result().energy.cutting, with.last_result().energy.cutting);
    EXPECT_FALSE(has_any(changed.last_result().status, StepStatus::removed_list_full));
  }
}

TEST(SetTool, RefusesTheToolsThatTheConstructorRefusesAndThenChangesNothing) {
  Simulation simulation(block(), ball(1e-3), config());
  EXPECT_THROW(simulation.set(ball(0.5e-4)), Error);  // thinner than a voxel
  EXPECT_THROW(simulation.set(ball(1)), Error);       // not millimetres
  EXPECT_EQ(std::get<SphereHead>(simulation.tool().head().shape()).radius, 1e-3);
  EXPECT_EQ(simulation.totals().exchanges, 0U);

  SimulationConfig of_a_drill = config();
  of_a_drill.law = std::make_shared<TwistDrillLaw>(TwistDrillLaw::Constants{});
  Simulation drilled(block(), Tool(twist_drill_head(2e-3, 4e-3), RayHandle{0}, Spindle{1000 * units::rad_per_s}),
                     of_a_drill);
  EXPECT_THROW(drilled.set(ball(1e-3)), Error) << "the law is for another kind of head";
}

TEST(PreparedTool, IsForVoxelsOfOneSize) {
  Simulation simulation(block(), ball(1e-3), config());
  PreparedTool other(ball(2e-3), 1e-4, config());
  EXPECT_FALSE(simulation.exchange(other));
  EXPECT_EQ(std::get<SphereHead>(other.tool().head().shape()).radius, 2e-3);
  PreparedTool fitting(ball(2e-3), 2e-4, config());
  EXPECT_EQ(fitting.worst_case().voxels, Simulation(block(), ball(2e-3), config()).worst_case().voxels);
  EXPECT_TRUE(simulation.exchange(fitting));
  EXPECT_EQ(std::get<SphereHead>(fitting.tool().head().shape()).radius, 1e-3) << "it holds the old one";
  EXPECT_TRUE(simulation.exchange(fitting)) << "and can be put back";
  EXPECT_EQ(std::get<SphereHead>(simulation.tool().head().shape()).radius, 1e-3);
  EXPECT_THROW(PreparedTool(ball(1e-3), 0, config()), Error);
  const PreparedTool moved = std::move(fitting);
  EXPECT_TRUE(fitting.empty() && !moved.empty());  // NOLINT(bugprone-use-after-move): the test
}

TEST(SetMaterials, ChangesWhatACutCostsAndKeepsTheRest) {
  Simulation simulation(block(), ball(1e-3), config());
  drill(simulation, 1e-3);
  const std::uint64_t cut = simulation.workpiece().hash();
  const double removed = simulation.totals().removed_volume[1];
  MaterialTable harder({material(9e8)});
  simulation.set(harder);
  EXPECT_EQ(simulation.workpiece().hash(), cut);
  EXPECT_EQ(simulation.totals().removed_volume[1], removed);
  EXPECT_EQ(simulation.workpiece().materials()[1].specific_cutting_energy, 9e8);
  EXPECT_EQ(simulation.totals().exchanges, 1U);

  // In fresh material every bit equals that of a simulation built with this material, also while the spindle starts.
  for (const double speed : {3000.0, 1.0}) {
    Simulation was(block(), ball(1e-3, speed), config());
    was.set(harder);
    Simulation is(build_block({Vec3(-6e-3, -6e-3, -6e-3), Vec3(6e-3, 6e-3, 0)}, 2e-4, material(9e8)), ball(1e-3, speed),
                  config());
    EXPECT_EQ(drill(was, 1e-3), drill(is, 1e-3));
    EXPECT_EQ(was.workpiece().hash(), is.workpiece().hash());
  }
}

TEST(SetMaterials, ChangesTheStiffnessOnlyToWhatTheDeviceRenders) {
  Material stiffer = material(3e8);
  stiffer.relative_stiffness = 4;
  const auto stiffness_in = [](const Simulation& simulation) { return simulation.config().reference_stiffness; };
  SimulationConfig of_device;
  of_device.device_stiffness = 700;
  Simulation automatic(block(), ball(1e-3), {}), rendered(block(), ball(1e-3), of_device),
      given(block(), ball(1e-3), config());
  const double chosen = stiffness_in(automatic), before = stiffness_in(rendered);
  for (Simulation* simulation : {&automatic, &rendered, &given}) simulation->set(MaterialTable({stiffer}));
  EXPECT_EQ(stiffness_in(automatic), chosen) << "it belongs to the head alone";
  EXPECT_DOUBLE_EQ(stiffness_in(rendered), before / 4);
  EXPECT_EQ(stiffness_in(given), 1e13);
}

TEST(SetMaterials, TakesTheirFrictionOver) {
  Material rough = material(3e8);
  rough.static_friction = rough.dynamic_friction = 0.9;
  Simulation was(block(), ball(1e-3, 0), config());
  was.set(MaterialTable({rough}));
  Simulation is(build_block({Vec3(-6e-3, -6e-3, -6e-3), Vec3(6e-3, 6e-3, 0)}, 2e-4, rough), ball(1e-3, 0), config());
  Simulation smooth(block(), ball(1e-3, 0), config());
  const auto drag = [](Simulation& simulation) {
    Vec3 force;
    for (int n = 0; n < 100; ++n)
      force = simulation.step(Pose::from_translation({2e-5 * n, 0, 0.7e-3}), {}, kStep).force;
    return force;
  };
  const Vec3 dragged = drag(was);
  EXPECT_EQ(dragged, drag(is));
  EXPECT_GT(std::abs(dragged.x()), 2 * std::abs(drag(smooth).x()));
}

TEST(SetMaterials, RefusesAnotherNumberOfThemAndStiffnessesOutOfRange) {
  Simulation simulation(block(), ball(1e-3), config());
  MaterialTable two({material(3e8), material(3e8, "other")});
  EXPECT_THROW(simulation.set(two), Error);
  Material stiff = material(3e8);
  stiff.relative_stiffness = 1e20;
  EXPECT_THROW(simulation.set(MaterialTable({stiff})), Error);
  EXPECT_EQ(simulation.workpiece().materials().size(), 1);
  EXPECT_EQ(simulation.totals().exchanges, 0U);
  PreparedMaterials prepared(two, config());
  EXPECT_FALSE(simulation.exchange(prepared));
  EXPECT_EQ(prepared.materials().size(), 2);
}

TEST(SetFriction, ActsFromTheNextStepOn) {
  Simulation simulation(block(), ball(1e-3, 0), config());
  const auto drag = [&](double from) {
    Vec3 force;
    for (int n = 0; n < 100; ++n)
      force = simulation.step(Pose::from_translation({from + 2e-5 * n, 0, 0.7e-3}), {}, kStep).force;
    return std::abs(force.x()) / force.z();
  };
  const double before = drag(0);
  EXPECT_THROW(simulation.set(DryFriction{-1, -1, 1000}), Error);
  simulation.set(DryFriction{0.05, 0.05, 1000});
  EXPECT_LT(drag(2e-3), 0.06);
  simulation.set(std::nullopt);
  EXPECT_NEAR(drag(-2e-3), before, 0.1 * before);  // elsewhere on the face, where voxels differ
  EXPECT_EQ(simulation.totals().exchanges, 2U);
}

TEST(SetRemoval, SwitchesCuttingOffAndOn) {
  Simulation simulation(block(), ball(1e-3), config());
  simulation.set(RemovalLaw::none);
  drill(simulation, 1e-3);
  EXPECT_EQ(simulation.totals().removed_volume[1], 0);
  simulation.set(RemovalLaw::constant_energy);
  drill(simulation, 1e-3, 3e-3);
  EXPECT_GT(simulation.totals().removed_volume[1], 0);
  const std::uint64_t exchanges = simulation.totals().exchanges;
  EXPECT_EQ(exchanges, 2U);
  simulation.set(RemovalLaw::constant_energy);
  EXPECT_EQ(simulation.totals().exchanges, exchanges) << "nothing has changed";
}

TEST(ExchangeOfAWorkpiece, BringsWorkpieceToolAndCountsOfTheOtherAndKeepsTheSettings) {
  Simulation simulation(block(), ball(1e-3), config());
  drill(simulation, 1e-3);
  Effects effects;
  effects.enabled.force = {true, false, true};
  simulation.set(effects);
  simulation.set(RemovalLaw::none);
  simulation.set(DryFriction{0.1, 0.1, 500});
  const std::uint64_t cut = simulation.workpiece().hash(), exchanges = simulation.totals().exchanges;
  Simulation other(block(1e-4), ball(0.5e-3), config());
  const std::uint64_t fresh = other.workpiece().hash();
  simulation.exchange(other);
  EXPECT_EQ(simulation.workpiece().hash(), fresh);
  EXPECT_EQ(std::get<SphereHead>(simulation.tool().head().shape()).radius, 0.5e-3);
  EXPECT_EQ(simulation.totals().removed_volume[1], 0);
  EXPECT_EQ(simulation.steps(), 0U);
  EXPECT_GT(simulation.totals().exchanges, exchanges);
  EXPECT_EQ(simulation.config().effects.enabled.force, effects.enabled.force);
  EXPECT_EQ(simulation.config().removal, RemovalLaw::none);
  EXPECT_EQ(simulation.config().friction->static_friction, 0.1);
  EXPECT_EQ(other.workpiece().hash(), cut) << "it holds the old one";
  EXPECT_TRUE(drill(simulation, 0.5e-3).isZero(0)) << "the tool waits";
  simulation.step(Pose::from_translation({0, 0, 2e-3}), {}, 1e-3);
  EXPECT_GT(drill(simulation, 0.5e-3).norm(), 0);
}

TEST(HaltSpindle, StopsAtOnceWithAnyRamp) {
  Spindle slow{3000 * units::rad_per_s};
  slow.acceleration_limit = 100;
  Simulation simulation(block(), Tool(SphereHead{1e-3}, RayHandle{0}, slow), config());
  simulation.spindle().halt();
  drill(simulation, 1e-3);
  EXPECT_EQ(simulation.last_result().spindle.speed, 0);
  EXPECT_EQ(simulation.totals().removed_volume[1], 0);
}

}  // namespace
}  // namespace hapticut::exchange_test
