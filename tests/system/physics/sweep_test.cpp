// SPDX-License-Identifier: Apache-2.0
// Swept motion: the removal of a stroke does not depend on its speed or on its
// division into steps.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>

#include "experiments/setup/cutting.hpp"
#include "hapticut/device/simulated/device_models.hpp"
#include "hapticut/loop/coupling_gains.hpp"
#include "hapticut/simulation/coupling.hpp"
#include "hapticut/workpiece/material_presets.hpp"

namespace hapticut::sweep_test {
namespace {

using namespace test;
using units::mm;

/// A block that is so easy to cut that its engaged layer is far below a voxel at all speeds.
Workpiece butter(double half_length) {
  Material material = plain_material();
  material.specific_cutting_energy = 1e3;
  return build_block({Vec3(-half_length, -2 * mm, -2 * mm), Vec3(half_length, 2 * mm, 0)}, kVoxel, material);
}

/// A ball that grooves a block from end to end, half its radius deep.
Simulation soft_groove() { return Simulation(butter(6 * mm), tool_of(SphereHead{kRadius}, 20000)); }

const Vec3 kStart = Vec3(-8.013, 0.007, 0.5) * mm;
constexpr double kTravel = 16 * mm;

TEST(Sweep, AStrokeAtHalfAMeterPerSecondRemovesTheVolumeOfASlowOne) {
  Simulation slow = soft_groove();
  Simulation fast = soft_groove();
  const double slow_volume = feed(slow, kStart, Vec3(0.01, 0, 0), kTravel, 1e-3).removed_volume;
  const double fast_volume = feed(fast, kStart, Vec3(0.5, 0, 0), kTravel, 1e-3).removed_volume;
  EXPECT_NEAR(fast_volume / slow_volume, 1, 0.01);
  // The groove is a circular segment, 12 mm long.
  const double half_angle = std::acos(0.5);
  const double segment = kRadius * kRadius * (half_angle - std::sin(half_angle) * std::cos(half_angle));
  EXPECT_NEAR(slow_volume / (segment * 12 * mm), 1, 0.02);
}

TEST(Sweep, AFastStrokeLeavesNoGap) {
  Simulation fast = soft_groove();
  (void)feed(fast, kStart, Vec3(0.5, 0, 0), kTravel, 1e-3);
  // Along the bottom of the groove, two voxels above its floor, nothing is left anywhere.
  const GridFrame& frame = fast.workpiece().frame();
  for (double x = -5.9 * mm; x < 5.9 * mm; x += 0.1 * mm) {
    const Vec3 p = frame.X_WV.inverse() * Vec3(x, 0, -0.28 * mm) / frame.voxel_size;
    const VoxelIndex index = {int(std::lround(p.x())), int(std::lround(p.y())), int(std::lround(p.z()))};
    EXPECT_EQ(fast.workpiece().fill_at(index), 0) << "at x = " << x / mm << " mm";
  }
}

TEST(Sweep, ATurnOfTheHandleIsSweptToo) {
  // A ball at the end of a 30 mm handle that rotates by 0.4 rad in 20 ms; the head moves on an arc through the block.
  const auto removed_with = [&](int steps) {
    Simulation simulation(butter(10 * mm),
                          Tool(SphereHead{kRadius}, RayHandle{30 * mm}, Spindle{20000 * units::rad_per_s}));
    double removed = 0;
    for (int i = 0; i < steps; ++i) {
      const double angle = -0.2 + 0.4 * (i + 1) / steps;
      const Pose pose{rotation_from_vector(Vec3(0, angle, 0)), Vec3(0, 0, 30.4) * mm};
      removed += simulation.step(pose, {Vec3::Zero(), Vec3(0, 20, 0)}, 0.02 / steps).removed_volume;
    }
    return removed;
  };
  EXPECT_NEAR(removed_with(20) / removed_with(1000), 1, 0.01);
}

TEST(Sweep, AStepLongerThanTheLongestSweepIsAJump) {
  Simulation simulation = soft_groove();
  (void)simulation.step(Pose::from_translation(kStart), {}, 1e-3);
  const double longest = simulation.config().max_sweep * 0.05 * mm;
  const StepResult& within = simulation.step(Pose::from_translation(kStart + Vec3(0.999 * longest, 0, 0)), {}, 1e-3);
  EXPECT_EQ(within.sub_steps, simulation.config().max_sweep);
  const StepResult& beyond = simulation.step(Pose::from_translation(kStart + Vec3(2.1 * longest, 0, 0)), {}, 1e-3);
  EXPECT_TRUE(has_any(beyond.status, StepStatus::jump_rejected));
}

// The head moves on an arc, and its force works along the arc's chord in each step.
TEST(Sweep, ATiltOnALongHandleEntersNoEnergy) {
  constexpr double kLever = 60 * mm, kSpeed = 9, kTilt = 10 * units::deg;  // kSpeed [rad/s]
  const auto pose_at = [&](double time, double pressed) {
    const double tilt = kTilt * std::clamp(2 * time - 1, 0.0, 1.0);
    const Mat3 R = rotation_from_vector(Vec3(tilt * std::sin(kSpeed * time), tilt * std::cos(kSpeed * time), 0));
    const double depth = pressed * std::clamp(time / 0.4, 0.0, 1.0) - 0.005 * mm;
    return Pose{R, Vec3(0, 0, kRadius - depth) + R * Vec3(0, 0, kLever)};
  };
  for (const double rate : {500.0, 1000.0, 4000.0})
    for (const bool coupled : {false, true}) {
      SCOPED_TRACE(std::to_string(rate) + " Hz" + (coupled ? ", coupled" : ""));
      SimulationConfig config;
      config.contact_time = ContactTime::end;
      Simulation simulation(build_block({Vec3(-3, -3, -2) * mm, Vec3(3, 3, 0) * mm}, 0.1 * mm, presets::enamel()),
                            Tool(SphereHead{kRadius}, RayHandle{kLever}, Spindle{}), config);
      VirtualCoupling coupling(simulation, coupling_gains(capabilities(device_model("premium6dof"))));
      Pose last = pose_at(0, 0);
      for (int n = 1; n <= int(3 * rate); ++n) {
        const Pose at = pose_at(n / rate, coupled ? 1 * mm : 0.02 * mm);
        const Twist velocity = twist_between(last, at, 1 / rate);
        last = at;
        if (coupled)
          (void)coupling.step(at, velocity, 1 / rate);
        else
          (void)simulation.step(at, velocity, 1 / rate);
      }
      const EnergyLedger& energy = simulation.last_result().energy;
      EXPECT_GT(energy.hand_work, 0);
      EXPECT_LT(std::abs(energy.entered), 2e-3 * energy.turnover);
      EXPECT_LT(std::abs(coupling.last_result().energy.closure()), 1e-3);
    }
}

}  // namespace
}  // namespace hapticut::sweep_test
