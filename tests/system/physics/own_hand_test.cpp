// SPDX-License-Identifier: Apache-2.0
// The loop that a stranger writes: step(pose, velocity, dt), and its force on the device, without coupling and guard.
#include <gtest/gtest.h>

#include <algorithm>

#include "experiments/setup/cutting.hpp"
#include "hapticut/device/simulated/device_models.hpp"
#include "hapticut/force/stiffness.hpp"
#include "hapticut/simulation/exchange.hpp"
#include "hapticut/workpiece/material_presets.hpp"
#include "support/refusal.hpp"

namespace hapticut::own_hand_test {
namespace {

using namespace test;
using units::mm;
using units::rpm;

/// What a hand of 300 N/m feels that lowers a device of 80 g onto bone at 10 mm/s, presses with 1.5 N and holds on.
struct Felt {
  double max_force = 0;  // [N]
  double thrown = 0;     // [m] upwards, after the first touch
  double restless = 0;   // [N] from the smallest to the largest force of the last half second
  double removed = 0;    // [m^3]
};

Felt lower(const SimulationConfig& config, const ToolHead& head, AngularSpeed speed,
           const Material& material = presets::cortical_bone()) {
  constexpr double kMass = 0.08, kSpring = 300, kDamping = 4, kPress = 1.5;  // device and hand together
  Simulation simulation(plain_block(3 * mm, 3 * mm), Tool(head, RayHandle{0}, Spindle{speed}), config);
  PreparedMaterials materials(MaterialTable({material}), simulation.config());
  EXPECT_TRUE(simulation.exchange(materials));
  const double surface = -head.bounding_box().min.z();
  double z = surface + 0.5 * mm, v = 0, target = z, low = 1e9, high = -1e9, lowest = z;
  Felt felt;
  for (int tick = 0; tick < 2000; ++tick) {
    target = std::max(target - 1e-5, lowest - kPress / kSpring);
    const Pose pose = Pose::from_translation(Vec3(0.013 * mm, 0.021 * mm, z));
    const double force = simulation.step(pose, {Vec3(0, 0, v), Vec3::Zero()}, kTick).force.z();
    v += (force + kSpring * (target - z) - kDamping * v) / kMass * kTick;
    z += v * kTick;
    lowest = std::min(lowest, z);
    felt.max_force = std::max(felt.max_force, force);
    felt.thrown = std::max(felt.thrown, z - lowest);
    if (tick < 1500) continue;
    low = std::min(low, force), high = std::max(high, force);
  }
  felt.restless = high - low;
  felt.removed = simulation.totals().removed_volume[1];
  return felt;
}

DeviceCapabilities touch() { return capabilities(device_model("touch")); }

// With the defaults, which suit scripts and couplings, the same hand is hit by over 50 N and thrown off.
TEST(OwnHand, CutsCalmlyWithTheConfigurationForItsDevice) {
  const SimulationConfig ours = SimulationConfig::for_device(touch());
  for (const ToolHead& head : {ToolHead(SphereHead{1 * mm}), ToolHead(FlatHead{1 * mm, 2 * mm}),
                               ToolHead(ConeHead{45 * units::deg, 1.5 * mm}), ToolHead(SphereHead{0.5 * mm})}) {
    const Felt felt = lower(ours, head, 40000 * rpm), usual = lower({}, head, 40000 * rpm);
    EXPECT_LT(felt.max_force, 3) << head.description();
    EXPECT_LT(felt.thrown, 0.5 * mm) << head.description();
    EXPECT_LT(felt.restless, 0.3) << head.description();
    EXPECT_GT(felt.removed, 0) << head.description();
    EXPECT_GT(usual.max_force, 10 * felt.max_force) << head.description() << ": is for_device still needed?";
  }
}

TEST(OwnHand, IsCalmAtRestAndAfterTheMaterialWasMadeStiffer) {
  Material stiff = presets::cortical_bone();
  stiff.relative_stiffness = 20;
  for (const Material& material : {presets::cortical_bone(), stiff}) {
    const Felt felt = lower(SimulationConfig::for_device(touch()), SphereHead{1 * mm}, 0 * rpm, material);
    EXPECT_LT(felt.max_force, 3) << material.relative_stiffness;
    EXPECT_LT(felt.restless, 0.05) << material.relative_stiffness;
    EXPECT_EQ(felt.removed, 0) << material.relative_stiffness;
  }
}

TEST(OwnHand, KnowsItsDeviceAfterAnExchangeOfTheTool) {
  Simulation simulation(plain_block(), tool_of(SphereHead{1 * mm}), SimulationConfig::for_device(touch()));
  const auto expected = [](double radius) { return stiffness_for_device(SphereHead{radius}, touch().stiffness); };
  EXPECT_NEAR(simulation.config().reference_stiffness / expected(1 * mm), 1, 1e-9);
  PreparedTool small(tool_of(SphereHead{0.5 * mm}), kVoxel, simulation.config());
  ASSERT_TRUE(simulation.exchange(small));
  EXPECT_NEAR(simulation.config().reference_stiffness / expected(0.5 * mm), 1, 1e-9);
}

TEST(OwnHand, IsRefusedOnADeviceThatStatesNoStiffness) {
  DeviceCapabilities device = touch();
  device.stiffness = 0;
  expect_refused([&] { return SimulationConfig::for_device(device); },
                 {"states no stiffness", "set DeviceCapabilities::stiffness"});
}

}  // namespace
}  // namespace hapticut::own_hand_test
