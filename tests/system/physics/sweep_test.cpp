// SPDX-License-Identifier: Apache-2.0
// Swept motion: what a stroke removes does not depend on how fast it is or how it is cut into steps.
#include <gtest/gtest.h>

#include "support/cutting.hpp"

namespace hapticut::sweep_test {
namespace {

using test::feed;
using test::plain_material;
using units::mm;

constexpr double kRadius = 1 * mm;

/// A ball that grooves a block from end to end, half its radius deep, in material that yields at once.
Simulation soft_groove(const ToolHead& head) {
  Material butter = plain_material();
  butter.specific_cutting_energy = 1e3;  // engaged layer far below a voxel at any of the speeds
  SimulationConfig config;
  return Simulation(build_block({Vec3(-6, -2, -2) * mm, Vec3(6, 2, 0) * mm}, 0.1 * mm, butter),
                    Tool(head, RayHandle{0}, Spindle{20000 * units::rad_per_s}), config);
}

const Vec3 kStart = Vec3(-8.013, 0.007, 0.5) * mm;
constexpr double kTravel = 16 * mm;

TEST(Sweep, AStrokeAtHalfAMeterPerSecondRemovesTheVolumeOfASlowOne) {
  Simulation slow = soft_groove(SphereHead{kRadius});
  Simulation fast = soft_groove(SphereHead{kRadius});
  const double slow_volume = feed(slow, kStart, Vec3(0.01, 0, 0), kTravel, 1e-3).removed_volume;
  const double fast_volume = feed(fast, kStart, Vec3(0.5, 0, 0), kTravel, 1e-3).removed_volume;
  EXPECT_NEAR(fast_volume / slow_volume, 1, 0.01);
  // The groove is a circular segment, 12 mm long.
  const double half_angle = std::acos(0.5);
  const double segment = kRadius * kRadius * (half_angle - std::sin(half_angle) * std::cos(half_angle));
  EXPECT_NEAR(slow_volume / (segment * 12 * mm), 1, 0.02);
}

TEST(Sweep, AFastStrokeLeavesNoGap) {
  Simulation fast = soft_groove(SphereHead{kRadius});
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
  // A ball at the end of a 30 mm handle that turns by 0.4 rad in 20 ms, head on an arc through the block.
  Material butter = plain_material();
  butter.specific_cutting_energy = 1e3;
  const auto removed_with = [&](int steps) {
    Simulation simulation(build_block({Vec3(-10, -2, -2) * mm, Vec3(10, 2, 0) * mm}, 0.1 * mm, butter),
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
  Simulation simulation = soft_groove(SphereHead{kRadius});
  (void)simulation.step(Pose::from_translation(kStart), {}, 1e-3);
  const double longest = simulation.config().longest_sweep * 0.05 * mm;
  const StepResult& within = simulation.step(Pose::from_translation(kStart + Vec3(0.999 * longest, 0, 0)), {}, 1e-3);
  EXPECT_EQ(within.sub_steps, simulation.config().longest_sweep);
  const StepResult& beyond = simulation.step(Pose::from_translation(kStart + Vec3(2.1 * longest, 0, 0)), {}, 1e-3);
  EXPECT_TRUE(has_any(beyond.status, StepStatus::jump_rejected));
}

}  // namespace
}  // namespace hapticut::sweep_test
