// SPDX-License-Identifier: Apache-2.0
// Smooth surfaces: the side of a drill in its own hole, a pin pushed against the wall, a path around an edge.
#include <gtest/gtest.h>

#include "experiments/setup/cutting.hpp"
#include "hapticut/closed_forms.hpp"
#include "hapticut/tool/catalogue.hpp"
#include "hapticut/tool/shank.hpp"
#include "hapticut/workpiece/builders.hpp"
#include "hapticut/workpiece/material_presets.hpp"

namespace hapticut::smooth_sides_test {
namespace {

namespace forms = closed_forms;
using test::kOffGrid;
using test::kTick;
using test::on_foundation;
using test::plain_material;
using units::deg;
using units::mm;

constexpr double kRadius = 1.25 * mm;

Material bone(double friction) {
  Material material = plain_material();
  material.specific_cutting_energy = 3e8;
  material.cutting_ratio = 1;
  material.static_friction = material.dynamic_friction = friction;
  return material;
}

/// A block below z = 0 of the tool's own axes, which have the orientation `R` in the grid.
Workpiece block(const Mat3& R, double voxel, double depth, const Material& material, double hole = 0) {
  return test::body({Vec3::Constant(-5 * mm), Vec3::Constant(5 * mm)}, voxel, material, [=](const Vec3& p) {
    const Vec3 q = R.transpose() * p - kOffGrid;
    const double across = q.head<2>().norm() - 2 * mm;
    const double solid = std::max({q.z(), -depth - q.z(), across});
    return hole > 0 ? std::max(solid, hole - q.head<2>().norm()) : solid;
  });
}

struct Grid {
  double stiffness, voxel, tolerance;
};

/// A drill deep in its hole has the force of its point and no force along its side: the land cuts what the corner
/// leaves of the wall.
// Proves: smooth surfaces.
TEST(SmoothSides, ADrillDeepInItsHoleFeelsItsPointOnly) {
  constexpr double kSpin = 2000, kFeed = 2 * mm, kAngle = 59 * deg;
  const ToolHead drill = twist_drill_head(2 * kRadius, 6 * mm, 2 * kAngle);
  const double point = kRadius / std::tan(kAngle);
  const Wrench expected = forms::cone_plunge_wrench({3e8, 1, kSpin, kFeed}, kAngle, point);
  for (const Grid& grid : {Grid{1e14, 0.1 * mm, 0.05}, Grid{1e15, 0.1 * mm, 0.025}})
    for (const test::Orientation& orientation : test::kOrientations) {
      SCOPED_TRACE(std::string(orientation.name) + ", k_v " + std::to_string(grid.stiffness));
      Simulation simulation(block(orientation.R_WT, grid.voxel, 3.6 * mm, bone(0.3)), test::tool_of(drill, kSpin),
                            on_foundation(grid.stiffness, false));
      const test::SteadyState fed =
          test::feed(simulation, orientation.R_WT * (kOffGrid + Vec3(0, 0, 0.01 * mm)),
                     orientation.R_WT * Vec3(0, 0, -kFeed), 3 * mm, kTick, 0.8, orientation.R_WT);
      EXPECT_NEAR(fed.force.z() / expected.force.z(), 1, grid.tolerance);
      EXPECT_NEAR(fed.torque.z() / expected.torque.z(), 1, grid.tolerance);
      EXPECT_LT(fed.force.head<2>().norm(), 0.05 * expected.force.z());
      EXPECT_LT(test::unbooked(fed.energy), 1e-6);
    }
}

/// A pin that fills its hole and is pushed sideways by x presses a crescent of the wall with w = beta x cos(phi).
// Proves: smooth surfaces.
TEST(SmoothSides, C41APinPushedAgainstTheWallOfItsHole) {
  constexpr double kLength = 2 * mm, kPush = 0.1 * mm;
  const ToolHead pin =
      ProfileHead({0, {{kRadius, 0}, {kRadius, 6 * mm, 0, EdgeKind::smooth}, {0, 6 * mm, 0, EdgeKind::smooth}}});
  for (const Grid& grid : {Grid{1e14, 0.05 * mm, 0.03}, Grid{1e15, 0.05 * mm, 0.03}, Grid{1e15, 0.1 * mm, 0.04}})
    for (const test::Orientation& orientation : test::kOrientations) {
      SCOPED_TRACE(std::string(orientation.name) + ", k_v " + std::to_string(grid.stiffness));
      // Through the whole block, so that its end touches nothing.
      Simulation simulation(block(orientation.R_WT, grid.voxel, kLength, bone(0), kRadius), Tool(pin),
                            on_foundation(grid.stiffness, false));
      const Vec3 start = kOffGrid - Vec3(0, 0, 3 * mm);
      Vec3 force_T;
      for (int n = 1; n <= 100; ++n) {
        const Pose pose = {orientation.R_WT, orientation.R_WT * (start + Vec3(kPush * n / 100, 0, 0))};
        const Twist twist{orientation.R_WT * Vec3(kPush / 0.1, 0, 0), Vec3::Zero()};
        force_T = orientation.R_WT.transpose() * simulation.step(pose, twist, kTick).force;
      }
      EXPECT_NEAR(-force_T.x() / forms::pushed_pin_force(grid.stiffness, kRadius, kLength, kPush), 1, grid.tolerance);
      EXPECT_LT(std::abs(force_T.y()), 0.01 * std::abs(force_T.x()));
      EXPECT_LT(std::abs(force_T.z()), 0.01 * std::abs(force_T.x()));
    }
}

/// The path goes sideways into the wall, out over the edge, back and in again.
// Proves: smooth surfaces.
TEST(SmoothSides, AClosedPathOverTheRimOfAHoleCostsNoWork) {
  const ToolHead pin = on_shank(round_head(1.2 * mm), {0.8 * mm, 0.3 * mm, 1 * mm, 1.6 * mm, 8 * mm});
  for (const test::Orientation& orientation : test::kOrientations) {
    SCOPED_TRACE(orientation.name);
    Simulation simulation(block(orientation.R_WT, 0.1 * mm, 2.4 * mm, bone(0), 0.9 * mm), Tool(pin),
                          on_foundation(1e14, false));
    const std::vector<Vec3> corners = {{0, 0, -3}, {0.25, 0, -3}, {0.25, 0, 1.5}, {0, 0, 1.5}, {0, 0, -3}};
    double turnover = 0, last = 0, max_force = 0;
    for (std::size_t n = 0; n + 1 < corners.size(); ++n) {
      const Vec3 leg = (corners[n + 1] - corners[n]) * mm;
      const int steps = int(std::ceil(leg.norm() / (2e-3 * mm)));
      for (int i = 1; i <= steps; ++i) {
        const Pose pose = {orientation.R_WT, orientation.R_WT * (kOffGrid + corners[n] * mm + leg * i / steps)};
        const Twist twist{orientation.R_WT * leg / (steps * 1e-3), Vec3::Zero()};
        const StepResult& result = simulation.step(pose, twist, kTick);
        turnover += std::abs(result.energy.hand_work - last);
        last = result.energy.hand_work;
        max_force = std::max(max_force, result.force.norm());
      }
    }
    EXPECT_GT(max_force, 3);
    EXPECT_LT(std::abs(last), 1e-3 * turnover);
    EXPECT_LT(std::abs(simulation.last_result().energy.entered), 1e-3 * turnover);
  }
}

/// The rim of a spinning cone passes material, which is at the cone's side first and at its base then. No energy enters
/// that no force brought in.
// Proves: energy ledger.
TEST(SmoothSides, ARimThatPassesMaterialBooksNoEnergyFromNothing) {
  const Vec3 step = Vec3(0.012, 0, -0.034) * mm;
  SimulationConfig config;
  config.contact_time = ContactTime::end;
  double entered = 0, turnover = 0;
  for (int phase = 0; phase < 20; ++phase) {
    Simulation simulation(build_block({Vec3(0.5, -1, 2) * mm, Vec3(3, 1, 6) * mm}, 0.15 * mm, presets::enamel()),
                          Tool(ConeHead{std::atan(0.61 / 5), 5 * mm}, RayHandle{0}, Spindle{16000 * units::rpm}),
                          config);
    Vec3 p = Vec3(-0.3, 0.0137 * phase, 0.0171 * phase) * mm;
    for (int n = 0; n < 60; ++n) {
      p += step;
      simulation.step(Pose::from_translation(p), {step / kTick, Vec3::Zero()}, kTick);
    }
    const EnergyLedger& energy = simulation.last_result().energy;
    EXPECT_GT(energy.cutting, 0.1);
    entered += std::abs(energy.entered), turnover += energy.turnover;
  }
  EXPECT_LT(entered, 1e-3 * turnover);
}

}  // namespace
}  // namespace hapticut::smooth_sides_test
