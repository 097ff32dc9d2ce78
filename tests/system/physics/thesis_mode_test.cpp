// SPDX-License-Identifier: Apache-2.0
// The whole model of the thesis in one configuration: the result of a step equals
// that of its equations, one by one.
#include "hapticut/simulation/thesis_mode.hpp"
#include "hapticut/force/stiffness.hpp"

#include <gtest/gtest.h>

#include "hapticut/workpiece/material_presets.hpp"
#include "support/cutting.hpp"
#include "support/refusal.hpp"

namespace hapticut::thesis_mode_test {
namespace {

using namespace test;
using units::deg;
using units::kPi;
using units::mm;

constexpr double kStiffnessOfMaterial = 0.4, kDepth = 0.5 * mm;
constexpr double kSinglePrecision = 1e-5;  // [1] of sums of a thousand forces
const Vec3 kTo(0.013 * mm, 0.021 * mm, kRadius - kDepth);

const LHandle kHandle{40 * mm, 12 * mm, 60 * deg};

ThesisMode constants() {
  ThesisMode mode;
  mode.law.damping = 1e-4;
  mode.law.spin_torque = 0.2;
  mode.law.spin_exponent = 0.5;
  mode.law.required_power = 1;  // nothing is removed
  mode.update_rate = 1800;
  mode.tool_mass = 0.3;
  mode.center_of_mass = Vec3(0, 0, -0.03);
  mode.handle_torque_scale = 1.5;
  return mode;
}

Simulation over_block(const SimulationConfig& config, double spin) {
  Material material = plain_material();
  material.relative_stiffness = kStiffnessOfMaterial;
  return Simulation(build_block({Vec3(-2, -2, -2) * mm, Vec3(2, 2, 0) * mm}, kVoxel, material),
                    Tool(SphereHead{kRadius}, kHandle, Spindle{spin * units::rad_per_s}), config);
}

/// Head at a depth below the surface, its axis vertical.
Pose handle_at(const Simulation& simulation, double depth) {
  return Pose::from_translation(Vec3(0.013 * mm, 0.021 * mm, kRadius - depth)) * simulation.tool().X_HT().inverse();
}

/// Calls a function with the vector [m] from the ball's centre to the centre of each voxel around the ball.
template <class See>
void for_each_place(const See& see) {
  for (int i = -20; i < 20; ++i)
    for (int j = -20; j < 20; ++j)
      for (int n = -20; n < 0; ++n) see(Vec3(kVoxel * (Vec3(i, j, n) + Vec3::Constant(0.5)) - kTo));
}

/// Equations 5.5-5.8, summed over the voxels inside the ball without the library.
struct ByHand {
  double normal_sum = 0;  // [N]
  int voxels = 0;
  Wrench wrench_T;

  explicit ByHand(const ThesisLaw::Constants& c, const Vec3& velocity, double spin) {
    const double k = kStiffnessOfMaterial * kStiffnessOfPoints * std::pow(c.reference_voxel_size, 2);
    for_each_place([&](const Vec3& r) {
      const double w = kRadius - r.norm();
      if (!(w > 0)) return;
      const Vec3 force = -k * kVoxel * w * r.normalized() - c.damping * velocity;
      wrench_T.force += force;
      wrench_T.torque += r.cross(force);
      normal_sum += k * kVoxel * w;
      ++voxels;
    });
    wrench_T.torque.z() -=
        std::copysign(c.spin_torque * std::pow(std::abs(spin), c.spin_exponent) * kRadius * normal_sum, spin);
  }
};

// Proves: thesis mode.
TEST(ThesisMode, GivesForceTorqueWeightVibrationAndFilterOfTheThesisTogether) {
  const double spin = 900;
  const ThesisMode mode = constants();
  Simulation simulation = over_block(thesis_mode(mode), spin);
  const Vec3 velocity(0.002, -0.001, -0.003);
  const Twist moving{velocity, Vec3::Zero()};
  const double dt = 1 / mode.update_rate;
  (void)simulation.step(handle_at(simulation, kDepth), moving, dt);
  const Vec3 before = simulation.last_result().force;
  const StepResult& result = simulation.step(handle_at(simulation, kDepth), moving, dt);

  const ByHand expected(mode.law, velocity, spin);
  EXPECT_EQ(result.contact.voxels, expected.voxels);
  EXPECT_LT((result.model.force - expected.wrench_T.force).norm(), kSinglePrecision * expected.normal_sum);

  // Equations 5.12-5.14.
  const Mat3 R_WH = handle_at(simulation, kDepth).rotation;
  const Vec3 at_hand = R_WH * thesis_handle_torque(kHandle, R_WH.transpose() * expected.wrench_T.force,
                                                   expected.wrench_T.torque.z(), 1.5);
  EXPECT_LT((result.model.torque - at_hand).norm(), kSinglePrecision * expected.normal_sum * 50 * mm);

  // Equations 5.9, 5.10 and Table 6.1: the target is some newtons away, so the output changes by epsilon towards it.
  const Vec3 weight(0, 0, -0.3 * 9.80665);
  const Vec3 shaken = 0.3 * std::sin(2 * kPi * 500 * 2 * dt) * Vec3::UnitZ();
  const Vec3 wanted = result.model.force + weight + shaken;
  ASSERT_GT((wanted - before).norm(), DeltaFilter{}.delta);
  EXPECT_NEAR((result.force - before).norm(), DeltaFilter{}.epsilon, 1e-12);
  EXPECT_LT((result.force - before).cross(wanted - before).norm(), 1e-9 * (wanted - before).norm());

  // The torque is not filtered. It is the torque of the handle, of the weight, and of the vibration at its lever arm.
  const Vec3 of_weight = (R_WH * mode.center_of_mass).cross(weight);
  const Vec3 arm = simulation.tool().X_HT().translation;
  const Vec3 of_shaking = (R_WH * arm).cross(shaken);
  EXPECT_LT((result.torque - at_hand - of_weight - of_shaking).norm(),
            kSinglePrecision * expected.normal_sum * 50 * mm);
}

// Equations 5.15-5.16: P = lambda omega^m R k l w omega >= c k, that is w >= c/(lambda omega^(m+1) R l).
// Proves: thesis mode.
TEST(ThesisMode, RemovesWholeVoxelsThatAreDeepEnoughForTheRequiredPower) {
  const double spin = 900, deepest_kept = 0.2 * mm;
  ThesisMode mode = constants();
  mode.law.required_power = mode.law.spin_torque * std::pow(spin, 1.5) * kRadius * kVoxel * deepest_kept;
  Simulation simulation = over_block(thesis_mode(mode), spin);
  const Pose at = handle_at(simulation, kDepth);
  const StepResult& first = simulation.step(at, {}, 1e-3);
  int deeper = 0;
  for_each_place([&](const Vec3& r) { deeper += kRadius - r.norm() >= deepest_kept ? 1 : 0; });
  EXPECT_GT(deeper, 50);
  EXPECT_EQ(int(first.removed_voxels.size()), deeper);
  EXPECT_NEAR(first.removed_volume / (deeper * std::pow(kVoxel, 3)), 1, 1e-12);
  EXPECT_EQ(simulation.step(at, {}, 1e-3).removed_volume, 0) << "the rest stays, however long";
}

// Table 5.2 with mu_s = mu_d = 0.3, whatever the material.
// Proves: thesis mode.
TEST(ThesisMode, DragsAStandingBallWithTheFrictionOfTheCaseStudy) {
  ThesisMode mode;
  Simulation simulation = over_block(thesis_mode(mode), 0);
  Pose pose = handle_at(simulation, kDepth);
  for (int i = 0; i < 400; ++i) {
    pose.translation.x() += 2e-6;
    (void)simulation.step(pose, {}, 1e-3);
  }
  const Vec3 force = simulation.last_result().model.force;
  // 5 % above the ratio, because friction is proportional to the sum of the normal forces, which are inclined.
  EXPECT_NEAR(-force.x() / force.z(), 0.315, 0.02) << "whole voxels come and go";
}

// Proves: thesis mode.
TEST(ThesisMode, LeavesOutWhatTheRateCannotShowAndRefusesWhatNoToolHas) {
  EXPECT_FALSE(thesis_mode().effects.vibration.has_value()) << "500 Hz at 1 kHz is zero at every sample (D9)";
  EXPECT_FALSE(thesis_mode().effects.gravity.has_value());
  ThesisMode mode;
  mode.update_rate = 1200;
  EXPECT_EQ(thesis_mode(mode).effects.vibration->frequency, 500);
  mode.tool_mass = -1;
  expect_refused([&] { return thesis_mode(mode); }, {"ThesisMode::tool_mass [kg] = -1; must be"});
  mode = {};
  mode.law.reference_voxel_size = -1;
  expect_refused([&] { return thesis_mode(mode); }, {});
}

// The heads range from a mastoid bur to a small bur at the speed of a turbine.
TEST(ThesisMode, IsFeltAndCutsWithItsDefaults) {
  struct Bur {
    double radius, spin;  // [m], [rad/s]
  };
  for (const Bur& bur : {Bur{2.5 * mm, 80000 * units::rpm}, Bur{1.5 * mm, 40000 * units::rpm},
                         Bur{1 * mm, 30000 * units::rpm}, Bur{0.5 * mm, 300000 * units::rpm}}) {
    Simulation simulation(build_block({Vec3(-4, -4, -2) * mm, Vec3(4, 4, 0) * mm}, kVoxel, presets::cortical_bone()),
                          Tool(SphereHead{bur.radius}, RayHandle{0}, Spindle{bur.spin * units::rad_per_s}),
                          thesis_mode());
    const double depth = 0.8 * bur.radius, feed = 4 * mm;
    double force = 0;  // [N] maximum
    const int steps = int(depth / feed / 1e-3);
    for (int n = 1; n <= steps; ++n) {
      const Pose pose = Pose::from_translation(Vec3(0.013 * mm, 0.021 * mm, bur.radius - n * depth / steps));
      force = std::max(force, simulation.step(pose, {Vec3(0, 0, -feed), Vec3::Zero()}, 1e-3).force.norm());
    }
    EXPECT_GT(force, 0.1) << bur.radius;
    EXPECT_LT(force, 20) << bur.radius;
    EXPECT_GT(simulation.removed_volume_by_material()[1], 0) << bur.radius;
  }
}

}  // namespace
}  // namespace hapticut::thesis_mode_test
