// SPDX-License-Identifier: Apache-2.0
// A spinning tool pressed into the corner of two faces. Its drag along one face presses it on the other, and only a
// stiffness matrix that contains the drag finds the balance of forces (docs/decisions/0005-implicit-coupling.md).
#include <gtest/gtest.h>

#include <cmath>

#include "support/coupling.hpp"

namespace hapticut::coupling_corner_test {
namespace {

using namespace test;
using units::deg;
using units::mm;

/// A block without one quadrant along y, with walls at x > 0 and z < 0.
Workpiece corner(const Material& material, double voxel) {
  return body({Vec3(-4, -2, -2) * mm, Vec3(2, 2, 4) * mm}, voxel, material, [](const Vec3& p) {
    return std::max(-std::max(p.x(), -p.z()), (p.cwiseAbs() - Vec3::Constant(5 * mm)).maxCoeff());
  });
}

struct CornerRun {
  double max_force = 0, closure = 0, removed = 0;
  double max_speed = 0;  // [m/s]
  int unsolved = 0, braked = 0, steps = 0, most_in_a_tick = 0;
};

/// A hand that moves 3 mm into the corner, circles there, and comes back.
CornerRun push_into_corner(double kappa, double spin, bool hard, double stiffness) {
  Material material = plain_material();
  material.cutting_ratio = kappa;
  if (hard) material.specific_cutting_energy = 1e14;  // nothing is cut
  const Tool tool(SphereHead{kRadius}, RayHandle{0}, Spindle{spin * units::rad_per_s});
  Simulation simulation(corner(material, 0.1 * mm), tool, implicit(stiffness));
  CouplingGains gains = touch_gains();
  VirtualCoupling coupling(simulation, gains);
  CornerRun run;
  Vec3 last = Vec3(-1.3, 0, 1.3) * mm;
  for (int n = 0; n < 800; ++n) {
    const double time = n * kTick, depth = time < 0.3 ? time / 0.3 : time < 0.6 ? 1 : (0.8 - time) / 0.2;
    const double angle =
        45 * deg + (time > 0.3 && time < 0.6 ? 0.5 * std::sin((time - 0.3) / 0.3 * 2 * units::kPi) : 0);
    const Vec3 hand = Vec3(-1.3, 0, 1.3) * mm + depth * 3 * mm * Vec3(std::sin(angle), 0, -std::cos(angle));
    const CoupledResult& result =
        coupling.step(Pose::from_translation(hand), {(hand - last) / kTick, Vec3::Zero()}, kTick);
    last = hand;
    run.max_force = std::max(run.max_force, result.coupling.force.norm());
    run.unsolved += has_any(result.status, StepStatus::not_in_balance);
    run.braked += has_any(result.status, StepStatus::tool_braked);
    run.max_speed = std::max(run.max_speed, result.V_WH.linear.norm());
    run.steps += result.newton_steps;
    run.most_in_a_tick = std::max(run.most_in_a_tick, result.newton_steps);
    run.removed += result.removed_volume;
  }
  run.closure = coupling.last_result().energy.closure();
  return run;
}

TEST(CouplingCorner, FindsTheBalanceOfForcesAtEveryCuttingRatio) {
  for (const double kappa : {0.5, 1.0, 2.0, 3.3, 5.0})
    for (const bool hard : {true, false})
      for (const double spin : {kSpin, -kSpin, 100.0}) {
        const CornerRun run = push_into_corner(kappa, spin, hard, 1e16);
        SCOPED_TRACE("kappa " + std::to_string(kappa) + (hard ? ", hard" : ", cut") + ", spin " + std::to_string(spin));
        EXPECT_LE(run.unsolved, 8) << "of 800 ticks, by the imbalance of work";
        EXPECT_LT(std::abs(run.closure), 1e-2);
        EXPECT_LT(run.max_speed, 0.5) << "m/s: it is braked, and the status reports it";
        if (run.max_speed > 0.15) {
          EXPECT_GT(run.braked, 0);
        }
        EXPECT_LE(run.max_force, 3.3 * (1 + 1e-9)) << "spring and damper together";
        EXPECT_LE(run.most_in_a_tick, 100) << "the contact is small";
      }
}

}  // namespace
}  // namespace hapticut::coupling_corner_test
