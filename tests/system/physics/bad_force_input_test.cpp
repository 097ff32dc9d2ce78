// SPDX-License-Identifier: Apache-2.0
// Constants, profiles and laws that do not fit are refused with value, range and
// cure, and change nothing.
#include <gtest/gtest.h>

#include "experiments/setup/cutting.hpp"
#include "support/laws.hpp"
#include "support/refusal.hpp"

namespace hapticut::bad_force_input_test {
namespace {

using namespace test;
using units::mm;

/// Expects a whole sentence with these words.
template <class Action>
void expect_refused(const Action& action, std::initializer_list<std::string> words) {
  test::expect_refused(action, words);
  EXPECT_TRUE(refusal(action).ends_with('.')) << refusal(action);
}

Workpiece block(const Material& material = plain_material()) {
  return build_block({Vec3(-1.5, -1.5, -1.5) * mm, Vec3(1.5, 1.5, 0) * mm}, 0.1 * mm, material);
}

Simulation ball_on_block(const SimulationConfig& config) {
  return Simulation(block(), tool_of(SphereHead{kRadius}, kSpin), config);
}

TEST(BadForceInput, ADynamicFrictionAboveTheStaticOneIsRefused) {
  Material material = plain_material();
  material.static_friction = 0.2;
  material.dynamic_friction = 0.3;
  expect_refused([&] { (void)block(material); }, {"dynamic_friction = 0.3", "static_friction = 0.2"});
}

TEST(BadForceInput, NegativeConstantsAreRefusedByName) {
  for_each_number<Material>([](const auto& field) {
    Material material = plain_material();
    material.*field.member = -1;
    expect_refused([&] { (void)block(material); }, {field.name, "= -1; must be"});
  });

  const auto with = [](const auto& change) {
    SimulationConfig config;
    change(config);
    (void)ball_on_block(config);
  };
  expect_refused([&] { with([](auto& c) { c.reference_stiffness = -1; }); }, {"reference_stiffness", "-1", "must be"});
  expect_refused([&] { with([](auto& c) { c.friction = DryFriction{0.3, -0.1, 1}; }); }, {"-0.1", "must be"});
  expect_refused([&] { with([](auto& c) { c.friction = DryFriction{0.3, 0.3, -1}; }); }, {"-1", "must be"});
  expect_refused([&] { with([](auto& c) { c.effects.gravity = Gravity{-1}; }); }, {"Gravity::mass", "-1", "must be"});
  expect_refused([&] { with([](auto& c) { c.effects.vibration = Vibration{-1}; }); }, {"frequency", "-1", "must be"});
  expect_refused([&] { with([](auto& c) { c.effects.vibration = Vibration{100, -1}; }); }, {"amplitude", "-1"});
  expect_refused([&] { with([](auto& c) { c.effects.delta_filter = DeltaFilter{-1}; }); }, {"delta", "-1"});
  expect_refused([&] { with([](auto& c) { c.effects.limits.force_growth = -1; }); }, {"force_growth", "-1", "must be"});

  expect_refused(
      [] {
        Tool(SphereHead{1 * mm}, RayHandle{0}, Spindle{1 * units::rad_per_s, -1});
      },
      {"power_limit", "-1", "must be"});
}

// In single precision the contact would have infinite numbers, and a NaN force.
TEST(BadForceInput, ConstantsBeyondSinglePrecisionAreRefused) {
  const auto with = [](double Material::*member, double value) {
    return [member, value] {
      Material material = plain_material();
      material.*member = value;
      SimulationConfig config;
      config.reference_stiffness = 1e14;  // the default suits the stiffest material
      (void)Simulation(block(material), Tool(SphereHead{1 * mm}), config);
    };
  };
  expect_refused(with(&Material::damping, 1e50), {"damping", "= 1e+50", "must be between 0 and 1e+06"});
  expect_refused(with(&Material::cutting_ratio, 1e50), {"cutting_ratio", "= 1e+50", "must be between 0 and 1e+06"});
  expect_refused(with(&Material::specific_cutting_energy, 1e-50), {"specific_cutting_energy", "at least 1000"});
  expect_refused(with(&Material::specific_cutting_energy, 1e50), {"specific_cutting_energy", "between 1000 and 1e+18"});
  for (const double stiffness : {1e-50, 1e50})
    expect_refused(with(&Material::relative_stiffness, stiffness),
                   {"reference_stiffness times relative_stiffness of 'plain'", "must be between 1 and 1e+25"});
  for (const double speed : {1e39, -1e39}) {
    expect_refused([&] { Tool(SphereHead{1 * mm}, RayHandle{0}, Spindle{speed * units::rad_per_s}); },
                   {"Spindle::speed", "no spindle is faster than a million"});
    Simulation simulation(block(), Tool(SphereHead{1 * mm}));
    expect_refused([&] { simulation.spindle().set_speed(speed * units::rad_per_s); },
                   {"Spindle::speed", "no spindle is faster"});
    EXPECT_EQ(simulation.spindle().setting(), 0);
  }
}

TEST(BadForceInput, ALawThatGivesNoNumberGivesNoForceAndTheStatusSaysSo) {
  class Broken final : public ForceLaw {
    LawTotals evaluate(const HeadMotion&, const ContactMaterials&, ContactBlock& b) const noexcept override {
      for (int n = 0; n < b.lanes(); ++n) {
        b.force_x[std::size_t(n)] = b.force_y[std::size_t(n)] = b.force_z[std::size_t(n)] = std::nanf("");
        b.fill_after[std::size_t(n)] = b.fill[std::size_t(n)];
      }
      return {};
    }
  };
  SimulationConfig config;
  config.law = std::make_shared<Broken>();
  Simulation simulation = ball_on_block(config);
  EXPECT_EQ(simulation.step(Pose::from_translation(Vec3(0, 0, 2 * mm)), {}, 1e-3).status, StepStatus::ok);
  const Pose pressed = Pose::from_translation(Vec3(0, 0, 0.8 * mm));
  for (int tick = 0; tick < 2; ++tick) {
    const StepResult& result = simulation.step(pressed, {}, 0.1);
    EXPECT_TRUE(has_any(result.status, StepStatus::force_not_finite));
    EXPECT_EQ(result.force, Vec3::Zero());
    EXPECT_EQ(result.torque, Vec3::Zero());
    EXPECT_EQ(result.energy.imbalance(), 0);
  }
  EXPECT_EQ(simulation.probe(pressed, {}, 0.1).wrench.force, Vec3::Zero());
}

/// All results of a simulation after a step.
void expect_same(const StepResult& a, const StepResult& b) {
  EXPECT_EQ(a.force, b.force);
  EXPECT_EQ(a.torque, b.torque);
  EXPECT_EQ(a.removed_volume, b.removed_volume);
  EXPECT_EQ(a.energy.hand_work, b.energy.hand_work);
  EXPECT_EQ(a.energy.cutting, b.energy.cutting);
  EXPECT_EQ(a.spindle.speed, b.spindle.speed);
  EXPECT_EQ(a.status, b.status);
}

TEST(BadForceInput, NothingHasChangedAfterACallThatThrew) {
  SimulationConfig config;
  config.effects.gravity = Gravity{0.1};
  config.effects.vibration = Vibration{};
  Simulation calm = ball_on_block(config), disturbed = ball_on_block(config);
  const auto nothing = [] {
    return Workpiece::from_blocks({{0, 0, 0}, {15, 15, 15}}, GridFrame{0.1 * mm, {}}, MaterialTable({plain_material()}),
                                  [](const VoxelIndex&, BlockContent&) { return BlockKind::empty(); });
  };
  for (int tick = 1; tick <= 150; ++tick) {
    if (tick > 50 && tick % 10 == 0) {
      Effects bad = config.effects;
      bad.vibration->frequency = 500;
      EXPECT_THROW(disturbed.set(bad), Error);
      EXPECT_THROW(disturbed.spindle().set_speed(std::nan("") * units::rad_per_s), Error);
      EXPECT_THROW(disturbed.reset(nothing()), Error);
      EXPECT_THROW(disturbed.history().restore(WorkpieceSnapshot{}), Error);
      EXPECT_EQ(disturbed.steps(), calm.steps());
    }
    const Pose pose = Pose::from_translation(Vec3(0.03 * mm, 0.02 * mm, 1 * mm - 0.004 * mm * tick));
    expect_same(calm.step(pose, {}, 1e-3), disturbed.step(pose, {}, 1e-3));
  }
  EXPECT_GT(calm.last_result().energy.cutting, 0);
}

TEST(BadForceInput, AMaterialTableThatRefusedAMaterialIsUnchanged) {
  MaterialTable table({plain_material()});
  Material bad = plain_material();
  bad.edge_pressure = -1;
  EXPECT_THROW(table.add(bad), Error);
  EXPECT_EQ(table.size(), 1);
  EXPECT_EQ(table[1].edge_pressure, plain_material().edge_pressure);
}

}  // namespace
}  // namespace hapticut::bad_force_input_test
