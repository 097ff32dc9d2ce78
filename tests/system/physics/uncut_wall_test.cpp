// SPDX-License-Identifier: Apache-2.0
// A head on a rigid feed cuts less than it sweeps: the layer in which it presses stays on the wall (C43).
#include <gtest/gtest.h>

#include "experiments/setup/cutting.hpp"
#include "hapticut/closed_forms.hpp"
#include "hapticut/force/stiffness.hpp"
#include "hapticut/tool/catalogue.hpp"

namespace hapticut::uncut_wall_test {
namespace {

using namespace test;
using namespace units;

constexpr double kFeed = 5e-3;  // [m/s]
constexpr double kDeep = 2 * mm;

/// [m] Half of the width of a slot that the side of a cylinder cuts through a block.
double half_width(double spin, const Material& material, double voxel) {
  Simulation simulation(build_block({Vec3(-5, -2, -4) * mm, Vec3(5, 2, 0) * mm}, voxel, material),
                        tool_of(cylinder_head(2 * kRadius, 4 * mm), spin));
  const Pose X_TH = simulation.tool().X_HT().inverse();
  double removed = 0;
  const double begin = -5.5 * mm, measured = -1 * mm, end = 3 * mm;
  for (double x = begin; x < end; x += kFeed * kTick) {
    const Pose X_WT = Pose::from_translation(Vec3(x, 0.037 * mm, -kDeep));
    const StepResult& result = simulation.step(X_WT * X_TH, {Vec3(kFeed, 0, 0), Vec3::Zero()}, kTick);
    if (x > measured) removed += result.removed_volume;
  }
  return removed / (2 * kDeep * (end - measured));
}

TEST(UncutWall, IsAsThickAsC43Says) {
  const Material material = plain_material();
  for (const double krpm : {1.0, 5.0, 20.0})
    for (const double voxel : {0.1 * mm, 0.05 * mm}) {
      const closed_forms::SteadyCut cut = {.specific_cutting_energy = material.specific_cutting_energy,
                                           .cutting_ratio = material.cutting_ratio,
                                           .spin = krpm * 1000 * rpm,
                                           .feed_speed = kFeed};
      const double k_v = stiffness_for_head(cylinder_head(2 * kRadius, 4 * mm));
      const double left = closed_forms::wall_left_by_a_pass(cut, k_v, kRadius, kRadius);
      // C43 takes the layer as thin beside the head; the volume is known to 0.3 um of the wall.
      EXPECT_NEAR(kRadius - half_width(cut.spin, material, voxel), left, 0.15 * left + 0.3e-6)
          << krpm << " krpm, voxels of " << voxel << " m";
    }
}

}  // namespace
}  // namespace hapticut::uncut_wall_test
