// SPDX-License-Identifier: Apache-2.0
// The whole model of the thesis in one configuration: the result of a step equals
// that of its equations, one by one.
#include "hapticut/simulation/thesis_mode.hpp"
#include "hapticut/force/stiffness.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <string>
#include <vector>

#include "experiments/setup/cutting.hpp"
#include "support/refusal.hpp"
#include "support/touch_gains.hpp"

namespace hapticut::thesis_mode_test {
namespace {

using namespace test;
using units::deg;
using units::kPi;
using units::mm;

constexpr double kStiffnessOfMaterial = 0.4, kDepth = 0.5 * mm;
constexpr double kDampingOfMaterial = 5, kFriction = 0.3;  // [s/m], [1]
constexpr double kSinglePrecision = 1e-5;                  // [1] error of sums of a thousand forces
const Vec3 kTo(0.013 * mm, 0.021 * mm, kRadius - kDepth);

const LHandle kHandle{40 * mm, 12 * mm, 60 * deg};

ThesisMode constants() {
  ThesisMode mode;
  mode.law.damping = 1e-4;
  mode.law.spin_torque = 0.2;
  mode.law.spin_exponent = 0.5;
  mode.law.cutting_force = 1e6;  // nothing is removed
  mode.update_rate = 1800;
  mode.tool_mass = 0.3;
  mode.center_of_mass = Vec3(0, 0, -0.03);
  mode.handle_torque_scale = 1.5;
  return mode;
}

Simulation over_block(const SimulationConfig& config, double spin) {
  Material material = plain_material();
  material.relative_stiffness = kStiffnessOfMaterial;
  material.damping = kDampingOfMaterial;
  material.static_friction = material.dynamic_friction = kFriction;
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
    const double b = c.damping + kDampingOfMaterial * k * std::pow(c.reference_voxel_size, 2);
    for_each_place([&](const Vec3& r) {
      const double w = kRadius - r.norm();
      if (!(w > 0)) return;
      const Vec3 force = -k * kVoxel * w * r.normalized() - b * velocity;
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

  // The torque is that of the handle, of the weight, and of the force that vibration adds and the filter takes away.
  const Vec3 of_weight = (R_WH * mode.center_of_mass).cross(weight);
  const Vec3 arm = R_WH * simulation.tool().X_HT().translation;
  const Vec3 at_head = 1.5 * arm.cross(shaken + result.force - wanted);
  EXPECT_LT((result.torque - at_hand - of_weight - at_head).norm(), kSinglePrecision * expected.normal_sum * 50 * mm);
}

// Equations 5.15-5.16: P = lambda omega^m R k l w omega >= c k, that is w >= c/(lambda omega^(m+1) R l). The speed of
// the constants is half the speed of the spindle, so c allows 2^(m+1) times the depth. Proves: thesis mode.
TEST(ThesisMode, RemovesWholeVoxelsThatAreDeepEnoughForTheRequiredPower) {
  const double spin = 900, deepest_kept = 0.2 * mm;
  ThesisMode mode = constants();
  mode.law.cutting_speed = spin / 2 * units::rad_per_s;
  mode.law.cutting_force = ThesisLaw::cutting_force_for(std::pow(2, 1.5) * deepest_kept, kRadius, kVoxel);
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

// Table 5.2 with the mu_s = mu_d = 0.3 of case study 6.5.
// Proves: thesis mode.
TEST(ThesisMode, DragsAStandingBallWithTheFrictionOfItsMaterial) {
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

// --- with its defaults -----------------------------------------------------------------------------------------------

struct NamedHead {
  const char* name;
  ToolHead head;
};
const std::vector<NamedHead> kHeads = {
    {"ball", SphereHead{kRadius}}, {"cone", ConeHead{45 * deg, kRadius}}, {"flat", FlatHead{kRadius, kRadius}}};
constexpr std::array kSpeeds = {10'000 * units::rpm, 40'000 * units::rpm, 300'000 * units::rpm};
constexpr std::array kStiffnesses = {0.1, 0.4, 1.0};  // [1]
constexpr double kContinuous = 0.88;                  // [N] continuous force of a Touch

Simulation as_offered(const ToolHead& head, AngularSpeed speed, double stiffness, double voxel = kVoxel,
                      SimulationConfig config = thesis_mode()) {
  Material material = plain_material();
  material.relative_stiffness = stiffness;
  return Simulation(build_block({Vec3(-1.3, -1.3, -2) * mm, Vec3(1.3, 1.3, 0) * mm}, voxel, material),
                    Tool(head, RayHandle{0}, Spindle{speed}), config);
}

/// A head at a depth below the surface.
Pose at_depth(const ToolHead& head, double depth) {
  return Pose::from_translation(Vec3(0.013 * mm, 0.021 * mm, -head.bounding_box().min.z() - depth));
}

/// A hand that nothing deflects lowers the head by 0.6 mm, at 2 mm/s.
struct Lowered {
  double removed = 0;                    // [m^3]
  double middle = 0, last = 0, max = 0;  // [N] along the axis: at half the depth, at the end, maximum

  Lowered(const ToolHead& head, AngularSpeed speed, double stiffness, double voxel = kVoxel) {
    Simulation simulation = as_offered(head, speed, stiffness, voxel);
    for (int tick = 0; tick <= 300; ++tick) {
      const StepResult& result = simulation.step(at_depth(head, tick * 2e-6), {Vec3(0, 0, -2e-3), Vec3::Zero()}, kTick);
      last = result.model.force.z();
      max = std::max(max, last);
      if (tick == 150) middle = last;
    }
    removed = simulation.totals().removed_volume[1];
  }
};

// Proves: thesis mode.
TEST(ThesisMode, CutsUnderARigidHandAndMoreWithSpeed) {
  for (const auto& [name, head] : kHeads)
    for (const double stiffness : kStiffnesses) {
      const std::string which = std::string(name) + ", stiffness " + format_number(stiffness);
      EXPECT_EQ(Lowered(head, 0 * units::rpm, stiffness).removed, 0) << which << ", at rest";
      EXPECT_EQ(Lowered(head, 100 * units::rpm, stiffness).removed, 0) << which << ", at 100 rpm";
      double slower = 0;
      for (const AngularSpeed speed : kSpeeds) {
        const Lowered lowered(head, speed, stiffness);
        EXPECT_GT(lowered.removed, 1.05 * slower) << which << ", " << speed / units::rpm << " rpm";
        EXPECT_LT(lowered.max, kContinuous) << which << ", " << speed / units::rpm << " rpm";
        slower = lowered.removed;
      }
    }
}

// Under a rigid hand the stiffness changes the force, not the cut: the power that is generated and the power that is
// required are both proportional to it.
TEST(ThesisMode, PushesInProportionToTheStiffness) {
  for (const auto& [name, head] : kHeads) {
    const Lowered soft(head, kSpeeds[0], 0.1), hard(head, kSpeeds[0], 1);
    EXPECT_EQ(soft.removed, hard.removed) << name;
    EXPECT_NEAR(soft.last / hard.last, 0.1, 1e-5) << name;
  }
}

/// The force with which a flat head of 1 mm radius begins to cut: n_c voxels deep, pi R^2 k_1 Sum (n_c - j).
double first_cut(AngularSpeed speed, double stiffness, double voxel) {
  const FlatHead flat{1 * mm, 1 * mm, FlatRule::bottom_only};
  Simulation simulation = as_offered(flat, speed, stiffness, voxel);
  double before = 0;
  for (int tick = 0; tick < 3000; ++tick) {
    const StepResult& result = simulation.step(at_depth(flat, tick * 0.2e-6), {}, kTick);
    if (result.removed_volume > 0) return before;
    before = result.model.force.z();
  }
  return 0;
}

// Proves: thesis mode.
TEST(ThesisMode, BeginsToCutWithTheForceThatItsConstantsNameAtAnyVoxelSize) {
  const ThesisLaw::Constants constants;
  const auto layers = [](double n) { return (std::floor(n) + 1) * (n - std::floor(n) / 2); };
  const double n = ThesisLaw(constants).removal_depth(constants.cutting_speed, 1 * mm, kVoxel) / kVoxel;
  for (const double voxel : {kVoxel, kVoxel / 2})
    for (const double stiffness : {0.4, 1.0})
      for (const double slower : {0.5, 1.0, 2.0}) {
        const double expected = stiffness * constants.cutting_force * layers(n * slower) / layers(n);
        EXPECT_NEAR(first_cut(1 / slower * constants.cutting_speed, stiffness, voxel) / expected, 1, 0.02)
            << "area of a disc of whole voxels; stiffness " << stiffness << ", " << voxel / mm << " mm, 1/" << slower
            << " of the speed";
      }
}

/// A hand behind the coupling of a Touch that presses with a force for a second.
double cut_by_a_press(const ToolHead& head, AngularSpeed speed, double stiffness, double force) {
  SimulationConfig config = thesis_mode();
  config.contact_time = ContactTime::end;
  Simulation simulation = as_offered(head, speed, stiffness, kVoxel, config);
  VirtualCoupling coupling(simulation, touch_gains());
  double z = at_depth(head, -0.2 * mm).translation.z(), before = z;
  for (int tick = 0; tick < 1000; ++tick) {
    const CoupledResult& felt = coupling.step(Pose::from_translation(Vec3(0.013 * mm, 0.021 * mm, z)),
                                              {Vec3(0, 0, (z - before) / kTick), Vec3::Zero()}, kTick);
    before = z;
    z = std::max(z - 5e-6, felt.X_WH.translation.z() - force / coupling.gains().stiffness);
  }
  return simulation.totals().removed_volume[1];
}

// Proves: thesis mode.
TEST(ThesisMode, CutsUnderTheForceOfASmallDeviceAndMoreWithForceAndSpeed) {
  for (const auto& [name, head] : kHeads)
    for (const double stiffness : kStiffnesses) {
      const std::string which = std::string(name) + ", stiffness " + format_number(stiffness);
      EXPECT_EQ(cut_by_a_press(head, 0 * units::rpm, stiffness, kContinuous), 0) << which << ", at rest";
      double slower = 0;
      for (const AngularSpeed speed : kSpeeds) {
        const double removed = cut_by_a_press(head, speed, stiffness, kContinuous);
        EXPECT_GT(removed, slower) << which << ", " << speed / units::rpm << " rpm";
        slower = removed;
      }
      const double light = cut_by_a_press(head, kSpeeds[0], stiffness, 0.01 * stiffness);
      EXPECT_LT(light, 0.8 * cut_by_a_press(head, kSpeeds[0], stiffness, kContinuous)) << which;
    }
}

}  // namespace
}  // namespace hapticut::thesis_mode_test
