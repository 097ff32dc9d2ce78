// SPDX-License-Identifier: Apache-2.0
// The model of the thesis as printed: what it gives, its figures 7.1-7.3, and its defects beside the default model.
#include <gtest/gtest.h>

#include <cmath>

#include "hapticut/bench/closed_forms.hpp"
#include "support/cutting.hpp"
#include "support/laws.hpp"
#include "support/static_contact.hpp"

namespace hapticut::thesis_test {
namespace {

namespace forms = closed_forms;
using units::deg;
using units::mm;

constexpr double kPrinted = 1e-3;            // [1] the oracle's numbers have four digits
constexpr double kPartialVoxels = 0.01;      // [1] of partly filled voxels a fifth of the depth
constexpr double kSinglePrecision = 1e-4;    // [1] of sums of some thousand forces
constexpr double kMeetingLayers = 0.1;       // [1] of a mean over steps that meet layers of voxels at ever new places
constexpr double kTwoAndAHalfLayers = 0.25;  // [1] an engaged depth of 2.7 layers, of which 2 or 3 are met
constexpr double kSame = 1e-3;               // [1] of forces that only single precision may tell apart
constexpr double kRim = 0.02;                // [1] of whole voxels in a disk of thirty across its radius
constexpr double kSlope = 0.1;               // [1] of whole voxels along a slope, two to a layer
constexpr double kRound = 0.05;              // [1] the same along a ball
constexpr double kThinLayer = 0.05;          // [1] of an engaged layer of a twentieth of the radius

/// A ball of radius 1 mm half a radius deep in a half space on its grid: [N] vertical force.
double pressed_ball(double voxel, double damping, double speed, bool thesis) {
  SimulationConfig config = test::static_config();
  config.reference_stiffness = 1e12;
  ThesisLaw::Constants constants;
  constants.reference_voxel_size = 0.1 * mm;
  constants.damping = damping;
  if (thesis) config.law = std::make_shared<ThesisLaw>(constants);
  Simulation simulation(test::box_at_phase({Vec3(-1.2, -1.2, -0.8) * mm, Vec3(1.2, 1.2, 0) * mm}, voxel, Vec3::Zero()),
                        Tool(SphereHead{1 * mm}), config);
  return test::hold(simulation, Vec3(0, 0, 0.5 * mm), {Vec3(0, 0, speed), Vec3::Zero()}).force.z();
}

// Summed voxel by voxel on paper (docs/model.md, D1): 8.148, 32.690, 130.869 for l = 0.1, 0.05, 0.025 of the radius,
// with k = 1: each about 4 times the last. In the default model the force stays, 0.0815 k_v R^4.
// Proves: normal force.
TEST(ThesisDefects, D1TheForceGrowsFourfoldWhenTheVoxelsHalve) {
  const double k = 1e12 * std::pow(0.1 * mm, 2);  // [N/m^2]
  const double unit = k * mm * mm;                // of F = k l w with lengths in radii
  EXPECT_NEAR(pressed_ball(0.1 * mm, 0, 0, true) / unit, 8.148, 8 * kPrinted);
  EXPECT_NEAR(pressed_ball(0.05 * mm, 0, 0, true) / unit, 32.690, 32 * kPrinted);
  EXPECT_NEAR(pressed_ball(0.1 * mm, 0, 0, false) / pressed_ball(0.05 * mm, 0, 0, false), 1, kPartialVoxels);
}

// Proves: damping.
TEST(ThesisDefects, D2TheDamperCountsVoxelsAndHoldsTheToolBack) {
  const double spring = pressed_ball(0.1 * mm, 0, 0, true), finer = pressed_ball(0.05 * mm, 0, 0, true);
  EXPECT_NEAR(pressed_ball(0.1 * mm, 1, -1, true) - spring, 656, 0.5) << "b V for each of the 656 voxels inside";
  EXPECT_NEAR(pressed_ball(0.05 * mm, 1, -1, true) - finer, 5252, 5);
  EXPECT_LT(pressed_ball(0.1 * mm, 1, 1, true), 0) << "on retreat it pulls the tool in";
}

/// Mean thrust [N] of a flat head fed axially at speed v_f, over the second half of 0.6 mm.
double thrust(double feed_speed, bool thesis, double voxel = 0.05 * mm, double spin = 2000) {
  SimulationConfig config;
  config.reference_stiffness = thesis ? 1e13 : 2e14;  // the default model wants a thin engaged layer
  ThesisLaw::Constants constants;
  constants.required_power = 4e-9;
  if (thesis) config.law = std::make_shared<ThesisLaw>(constants);
  Simulation simulation(
      build_block({Vec3(-0.8, -0.8, -2) * mm, Vec3(0.8, 0.8, 0) * mm}, voxel, test::plain_material()),
      Tool(FlatHead{0.5 * mm, 2 * mm, FlatRule::bottom_only}, RayHandle{0}, Spindle{spin * units::rad_per_s}), config);
  return test::feed(simulation, Vec3(0.013, 0.021, 0) * mm, Vec3(0, 0, -feed_speed), 0.6 * mm, 1e-3).force.z();
}

// The engaged depth w* = c/(lambda R l |omega|) does not know the feed: it follows from the threshold alone.
// Proves: removal by law A.
TEST(ThesisDefects, D5ThrustDoesNotKnowTheFeedAndTheDefaultModelIsProportionalToIt) {
  const double slow = thrust(0.5e-3, true), fast = thrust(2e-3, true);
  EXPECT_NEAR(fast / slow, 1, kMeetingLayers);
  const double slow_default = thrust(0.5e-3, false), fast_default = thrust(2e-3, false);
  EXPECT_NEAR(fast_default / slow_default, 4, 4 * kMeetingLayers);
  const double depth = 4e-9 / (0.3 * 0.5 * mm * 0.05 * mm * 2000);
  const double k = 1e13 * std::pow(0.1 * mm, 2);
  EXPECT_NEAR(slow / forms::flat_bottom_force(k / std::pow(0.05 * mm, 2), 0.5 * mm, depth), 1, kTwoAndAHalfLayers);
}

// Proves: energy ledger.
TEST(ThesisDefects, D7TheWorkOfHandAndMotorDoesNotPayForTheRemovedVolume) {
  SimulationConfig config;
  ThesisLaw::Constants constants;
  constants.required_power = 4e-9;
  config.law = std::make_shared<ThesisLaw>(constants);
  Simulation simulation(
      build_block({Vec3(-0.8, -0.8, -2) * mm, Vec3(0.8, 0.8, 0) * mm}, 0.05 * mm, test::plain_material()),
      Tool(FlatHead{0.5 * mm, 2 * mm}, RayHandle{0}, Spindle{2000 * units::rad_per_s}), config);
  const auto cut = test::feed(simulation, Vec3::Zero(), Vec3(0, 0, -2e-3), 0.6 * mm, 1e-3);
  EXPECT_GT(cut.removed_volume, 0);
  EXPECT_EQ(cut.energy.cutting, 0);
  EXPECT_GT(cut.energy.released + cut.energy.rubbing, 0.9 * (cut.energy.hand_work + cut.energy.motor_work));
}

// Proves: law of the thesis; figures 7.1-7.3.
TEST(ThesisLaw, SpinTorqueIsLambdaTimesTheNormalForcesAndTheRadius) {
  for (const double spin : {100.0, -100.0}) {
    SimulationConfig config = test::static_config();
    ThesisLaw::Constants constants;
    constants.spin_torque = 0.2;
    constants.spin_exponent = 0.5;
    config.law = std::make_shared<ThesisLaw>(constants);
    Simulation simulation(
        test::box_at_phase({Vec3(-1.2, -1.2, -0.8) * mm, Vec3(1.2, 1.2, 0) * mm}, 0.1 * mm, Vec3::Zero()),
        Tool(FlatHead{1 * mm, 2 * mm, FlatRule::bottom_only}, RayHandle{0}, Spindle{spin * units::rad_per_s}), config);
    const StepResult& result = test::hold(simulation, Vec3(0, 0, -0.5 * mm));
    // All normal forces of the bottom are along the axis, so their sum is the force.
    EXPECT_NEAR(result.torque.z() / (-std::copysign(0.2 * 10 * 1 * mm * result.force.z(), spin)), 1, kSinglePrecision);
  }
}

// Proves: layers and grades; law of the thesis.
TEST(ThesisLaw, ForceFollowsTheStiffnessOfEachVoxel) {
  SimulationConfig config = test::static_config();
  config.law = std::make_shared<ThesisLaw>(ThesisLaw::Constants{});
  const auto layered = [&](double left, double right) {
    Simulation simulation(test::box_at_phase({Vec3(-1.2, -1.2, -0.8) * mm, Vec3(1.2, 1.2, 0) * mm}, 0.1 * mm,
                                             Vec3::Zero(), test::materials_of_stiffness({left, right}),
                                             [](const Vec3& p) { return MaterialId(p.x() < 0 ? 1 : 2); }),
                          Tool(SphereHead{1 * mm}), config);
    return test::hold(simulation, Vec3(0, 0, 0.6 * mm)).force;
  };
  const Vec3 equal = layered(0.5, 0.5), unequal = layered(0.3, 0.7);
  EXPECT_NEAR(unequal.z() / equal.z(), 1, kSinglePrecision) << "the halves weigh alike";
  EXPECT_LT(unequal.x(), -0.01 * equal.z()) << "the stiffer half pushes the tool away";
  EXPECT_NEAR(equal.x(), 0, kSinglePrecision * equal.z());
}

// --- figures 7.1-7.3: stepping into a cube, everything engaged is removed in each step (C33) -------------------------

struct Stepping {
  std::vector<double> volume, force, torque;  // per step
};

constexpr double kHeadSize = 0.3 * mm;  // R and H: 0.3 in the units of the thesis's scene
constexpr double kStep = 0.02 * mm;
constexpr int kSteps = 14;

Simulation cube(const ToolHead& head, SimulationConfig config, double voxel, double spin) {
  Material material = test::plain_material();
  material.relative_stiffness = 0.4;
  return Simulation(build_block({Vec3(-0.36, -0.36, -0.4) * mm, Vec3(0.36, 0.36, 0) * mm}, voxel, material),
                    Tool(head, RayHandle{0}, Spindle{spin * units::rad_per_s}), config);
}

/// Thesis mode: the tool jumps a step, rests for a tick, and whatever it touches goes.
Stepping step_down(const ToolHead& head, double voxel) {
  SimulationConfig config;
  config.longest_sweep = 1;
  config.reference_stiffness = 1e13;
  ThesisLaw::Constants constants;
  constants.required_power = 0;
  config.law = std::make_shared<ThesisLaw>(constants);
  Simulation simulation = cube(head, config, voxel, 1000);
  const double lowest = head.bounding_box().min.z();
  Stepping stepping;
  for (int i = 0; i <= kSteps; ++i) {
    const Pose pose = Pose::from_translation(Vec3(0, 0, -lowest - kStep * i));
    (void)simulation.step(pose, {}, 1e-3);
    const StepResult& result = simulation.step(pose, {}, 1e-3);
    if (i == 0) continue;
    stepping.volume.push_back(result.removed_volume);
    stepping.force.push_back(result.force.z());
    stepping.torque.push_back(-result.torque.z());
  }
  return stepping;
}

/// Energy mode: the tool is fed a step in 20 ms, with a thin engaged layer; means over the step.
Stepping feed_down(const ToolHead& head, double voxel) {
  SimulationConfig config;
  config.reference_stiffness = 1e17;  // 2 um, a tenth of a step
  Simulation simulation = cube(head, config, voxel, 20000);
  const double lowest = head.bounding_box().min.z();
  Stepping stepping;
  for (int i = 0; i < kSteps; ++i) {
    double volume = 0, force = 0, torque = 0;
    for (int tick = 1; tick <= 20; ++tick) {
      const double depth = kStep * (i + tick / 20.0);
      const Pose pose = Pose::from_translation(Vec3(0.0013 * mm, 0.0021 * mm, -lowest - depth));
      const StepResult& result = simulation.step(pose, {Vec3(0, 0, -kStep / 0.02), Vec3::Zero()}, 1e-3);
      volume += result.removed_volume;
      force += result.force.z() / 20;
      torque -= result.torque.z() / 20;
    }
    stepping.volume.push_back(volume);
    stepping.force.push_back(force);
    stepping.torque.push_back(torque);
  }
  return stepping;
}

// Proves: figures 7.1-7.3.
TEST(ThesisFigures, C33FlatIsConstantAndConeRisesEveryStep) {
  const double R = 0.3 * mm, D = 0.02 * mm, l = 0.01 * mm;
  const Stepping flat = step_down(FlatHead{R, 0.3 * mm, FlatRule::bottom_only}, l);
  const Stepping cone = step_down(ConeHead{45 * deg, 0.3 * mm}, l);
  const Stepping ball = step_down(SphereHead{R}, l);
  double total_cone = 0, total_ball = 0;
  for (std::size_t i = 0; i < flat.volume.size(); ++i) {
    const double d = D * double(i + 1);
    EXPECT_NEAR(flat.volume[i] / forms::step_volume_of_a_flat_head(R, D), 1, kRim);
    EXPECT_NEAR(flat.force[i] / flat.force[0], 1, kSame);
    EXPECT_NEAR(flat.torque[i] / flat.torque[0], 1, kSame);
    total_cone += cone.volume[i], total_ball += ball.volume[i];
    if (i >= 3) {
      EXPECT_NEAR(total_cone / forms::step_volume_of_a_cone(45 * deg, d, d), 1, kSlope);
      EXPECT_NEAR(total_ball / forms::step_volume_of_a_ball(R, d, d), 1, kRound);
    }
    if (i == 0) continue;
    EXPECT_GT(cone.volume[i], cone.volume[i - 1]);
    EXPECT_GT(cone.force[i], cone.force[i - 1]);
    EXPECT_GT(cone.torque[i], cone.torque[i - 1]);
    EXPECT_GT(ball.volume[i], 0.98 * ball.volume[i - 1]) << "rises and levels off towards d = R";
  }
}

// Proves: figures 7.1-7.3.
TEST(ThesisFigures, C33ForceOfAStepIsThatOfTheLayerItRemoves) {
  const double R = 0.3 * mm, D = 0.02 * mm, l = 0.01 * mm;
  // The springs of the thesis at voxel size l are those of k_v = k / l0^2 times (l0/l)^2.
  const double k_v = 0.4 * 1e13 * std::pow(0.1 * mm / l, 2);
  const Stepping flat = step_down(FlatHead{R, 0.3 * mm, FlatRule::bottom_only}, l);
  const Stepping cone = step_down(ConeHead{45 * deg, 0.3 * mm}, l);
  EXPECT_NEAR(flat.force[5] / forms::step_force_of_a_flat_head(k_v, R, D), 1, kRim);
  const double d = 12.5 * D;  // middle of the thirteenth layer
  // A layer two voxels thick: the sum over whole voxels is off by a few percent.
  EXPECT_NEAR(cone.force[12] / forms::step_force_of_a_cone(k_v, 45 * deg, d, D), 1, kSlope);
}

// In energy mode the volume of a step is the same, and its force the steady one: of C20 for the flat head, of C29 for
// the cone and of C28 for the ball in the middle of the step. The first step builds up the engaged layer; where the
// surface is a slope it lags behind.
// Proves: figures 7.1-7.3.
TEST(ThesisFigures, C33HoldsInEnergyModeToo) {
  const double R = kHeadSize, l = 0.01 * mm;
  const forms::SteadyCut cut{3e8, 0.5, 20000, kStep / 0.02};
  const Stepping flat = feed_down(FlatHead{R, 0.3 * mm, FlatRule::bottom_only}, l);
  const Stepping cone = feed_down(ConeHead{45 * deg, 0.3 * mm}, l);
  const Stepping ball = feed_down(SphereHead{R}, l);
  const double steady = forms::axial_cutting_force_of_a_flat_head(cut, R);
  const double couple = -forms::axial_cutting_torque_of_a_flat_head(cut, R);
  for (std::size_t i = 1; i < flat.force.size(); ++i) {
    EXPECT_NEAR(flat.volume[i] / forms::step_volume_of_a_flat_head(R, kStep), 1, kRim);
    EXPECT_NEAR(flat.force[i] / steady, 1, kThinLayer);
    EXPECT_NEAR(flat.torque[i] / couple, 1, kRim);
    const double d = kStep * double(i + 1), middle = d - kStep / 2;
    if (i >= 5) {
      EXPECT_NEAR(cone.volume[i] / forms::step_volume_of_a_cone(45 * deg, d, kStep), 1, kSlope);
      EXPECT_NEAR(ball.volume[i] / forms::step_volume_of_a_ball(R, d, kStep), 1, kRound);
      EXPECT_NEAR(cone.force[i] / forms::cone_plunge_wrench(cut, 45 * deg, middle).force.z(), 1, kSlope);
      EXPECT_NEAR(ball.force[i] / forms::ball_plunge_wrench(cut, R, middle).force.z(), 1, kRound);
    }
    EXPECT_GT(cone.volume[i], cone.volume[i - 1]);
    EXPECT_GT(cone.force[i], cone.force[i - 1]);
    EXPECT_GT(cone.torque[i], cone.torque[i - 1]);
    EXPECT_GT(ball.force[i], ball.force[i - 1]);
    EXPECT_GT(ball.torque[i], ball.torque[i - 1]);
  }
}

}  // namespace
}  // namespace hapticut::thesis_test
