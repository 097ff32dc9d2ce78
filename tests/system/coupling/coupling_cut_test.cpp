// SPDX-License-Identifier: Apache-2.0
// What a hand feels and cuts through the coupling. How fast a hand feeds a tool is rows of `hapticut validate`.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <optional>

#include "hapticut/tool/motors.hpp"
#include "hapticut/workpiece/material_presets.hpp"
#include "support/coupling.hpp"

namespace hapticut::coupling_cut_test {
namespace {

using namespace test;
using units::mm;

constexpr double kFineVoxel = 0.05 * mm;  // half of the thinnest engaged layer of 1e14 N/m^4

/// The force across the feed and the one along it bend the coupling as far as its spring says, while the same cut by a
/// driven tool meets the same force.
TEST(CouplingCut, FeelsTheForceAcrossTheFeedAsADrivenToolDoes) {
  const double feed = 2e-3;         // [m/s] along x
  constexpr double kRipple = 0.03;  // of voxels that are thicker than the layer
  for (const double k : {1e14, 1e15, 1e16}) {
    Simulation simulation(half_space(4 * mm, plain_material(), kFineVoxel), ball(kSpin), implicit(k));
    VirtualCoupling coupling(simulation, {});
    // In the air in front of the block, its centre at the surface: half of the ball cuts a groove.
    const Vec3 start = kAside + Vec3(-5.2 * mm, 0, 0);
    Vec3 mean = Vec3::Zero(), offset = Vec3::Zero();
    constexpr int kTicks = 2600, kFrom = 1800;
    for (int n = 0; n < kTicks; ++n) {
      const Vec3 hand = start + Vec3(feed * kTick * n, 0, 0);
      const CoupledResult& result = coupling.step(Pose::from_translation(hand), {Vec3(feed, 0, 0), {0, 0, 0}}, kTick);
      if (n < kFrom) continue;
      mean += result.coupling.force / (kTicks - kFrom);
      offset += (result.X_WH.translation - hand) / (kTicks - kFrom);
    }
    EXPECT_LT((mean - coupling.gains().stiffness * offset).norm(), 0.01 * mean.norm()) << k;
    EXPECT_LT(std::abs(coupling.last_result().energy.closure()), 1e-3) << k;
    EXPECT_LT(mean.y(), -0.25 * mean.norm()) << "the spin pushes the ball across the feed";

    // The tool runs `offset` beside the hand; driven along that line without a coupling it feels the same.
    Simulation driven(half_space(4 * mm, plain_material(), kFineVoxel), ball(kSpin), implicit(k));
    const SteadyState direct =
        test::feed(driven, start + offset, {feed, 0, 0}, kTicks * kTick * feed, kTick, double(kFrom) / kTicks);
    EXPECT_LT((direct.force - mean).norm(), kRipple * mean.norm()) << k;
    EXPECT_NEAR(direct.force.y(), mean.y(), kRipple * std::abs(mean.y())) << k;
  }
}

/// [mm^3] that a ball under about 1 N removes over 2.5 mm of a groove of a voxel's depth.
double light_groove(double dt) {
  constexpr double kBall = 1.5 * mm, kFeed = 2.5 * mm, kAbove = 0.05 * mm, kDown = 0.3, kFrom = 0.35, kUntil = 1.45;
  const Material bone = presets::cortical_bone();
  Simulation simulation(build_block({{-1.2 * mm, -1.2 * mm, -0.8 * mm}, {4 * mm, 1.2 * mm, 0}}, 0.1 * mm, bone),
                        Tool(SphereHead{kBall}, RayHandle{0}, common_spindle(40000 * units::rpm)),
                        implicit(0, std::nullopt));
  VirtualCoupling coupling(simulation, {});
  const double below = 1 / coupling.gains().stiffness;
  Vec3 last = kAside + Vec3(0, 0, kBall + kAbove);
  double removed = 0;
  for (int n = 1; n * dt < kUntil; ++n) {
    const double time = n * dt, down = (kAbove + below) * std::min(1.0, time / kDown);
    const Vec3 hand = kAside + Vec3(kFeed * std::max(0.0, time - kFrom), 0, kBall + kAbove - down);
    coupling.step(Pose::from_translation(hand), {(hand - last) / dt, Vec3::Zero()}, dt);
    last = hand;
    removed += coupling.last_result().removed_volume;
  }
  return removed / (mm * mm * mm);
}

// Where a tool trembles, chips do not get cheaper: by its speed of the moment it removed 8 % more at 4 than at 0.5 kHz.
TEST(CouplingCut, RemovesTheSameFromALightGrooveAtEveryRate) {
  const double slow = light_groove(2e-3), usual = light_groove(1e-3), fast = light_groove(0.25e-3);
  EXPECT_GT(usual, 0.05) << "it cuts";
  EXPECT_NEAR(slow, usual, 0.025 * usual);
  EXPECT_NEAR(fast, usual, 0.025 * usual);
}

}  // namespace
}  // namespace hapticut::coupling_cut_test
