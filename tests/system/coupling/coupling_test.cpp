// SPDX-License-Identifier: Apache-2.0
#include "hapticut/simulation/coupling.hpp"

#include <gtest/gtest.h>
#include <Eigen/Eigenvalues>

#include <cmath>

#include "hapticut/closed_forms.hpp"
#include "hapticut/core/errors.hpp"
#include "hapticut/device/simulated/device_models.hpp"
#include "hapticut/loop/coupling_gains.hpp"
#include "hapticut/tool/catalogue.hpp"
#include "hapticut/workpiece/material_presets.hpp"
#include "support/coupling.hpp"
#include "support/refusal.hpp"

namespace hapticut::coupling_test {
namespace {

using units::mm;
using namespace test;

class AnyStiffness : public testing::TestWithParam<double> {};

TEST_P(AnyStiffness, LetsTheToolRestOnTheSurfaceWithoutJitter) {
  Simulation simulation(half_space(), ball(), implicit(GetParam()));
  VirtualCoupling coupling(simulation, {});
  const PressedTool pressed = press(coupling);
  EXPECT_LT(pressed.jitter, 1e-9);
  EXPECT_LT(pressed.rebound, 0.5 * kApproach);
  EXPECT_LT(pressed.max_penetration, 1.25 * pressed.rest_penetration + 10e-6) << "no jump through the surface";
  // The hand feels only the spring of the coupling and, for the remaining motion, its damper.
  const CouplingGains& gains = coupling.gains();
  const double damper = gains.damping * coupling.last_result().V_WH.linear.z();
  EXPECT_NEAR(pressed.rest_force, kPress - gains.stiffness * pressed.rest_penetration + damper, 1e-9);
  EXPECT_LT(std::abs(coupling.last_result().energy.closure()), 1e-3);
  EXPECT_LT(unbooked(simulation.last_result().energy), 1e-5) << "finite turns of the anchor of friction";
}

/// Stiffnesses of the contact at rest from 3e4 to 1e6 N/m.
INSTANTIATE_TEST_SUITE_P(Foundations, AnyStiffness, testing::Values(1e14, 1e15, 1e16, 1e17, 1e18),
                         [](const auto& k) { return "1e" + std::to_string(int(std::lround(std::log10(k.param)))); });

TEST(Coupling, KeepsTheToolWithinATenthOfAMillimetreOfEnamelUnderFiveNewtons) {
  Simulation simulation(half_space(4 * mm, presets::enamel()), ball(), implicit(1e16));
  VirtualCoupling coupling(simulation, {});
  const PressedTool pressed = press(coupling);
  EXPECT_LT(pressed.rest_penetration, 0.1 * mm);
  EXPECT_GT(pressed.rest_force, 0.95 * kPress);
  EXPECT_LT(pressed.newton_steps, 1.3 * 2000) << "one Newton step is nearly always enough";
}

TEST(Coupling, IsHeldByAThinWallAndFeelsItBreak) {
  Simulation simulation(half_space(0.5 * mm), ball(), implicit(1e16));
  VirtualCoupling coupling(simulation, {});
  const PressedTool pressed = press(coupling);
  EXPECT_LT(pressed.rest_penetration, 0.15 * mm);
  EXPECT_GT(pressed.rest_force, 0.95 * kPress);

  // With the spindle running, the resting hand sinks; then the wall is cut and the force is zero.
  simulation.spindle().set_speed(kSpin * units::rad_per_s);
  const Pose hand = at_height(kRadius - kPress / coupling.gains().stiffness);
  double before_break = 0;
  int ticks = 0;
  while (coupling.step(hand, {}, kTick).coupling.force.z() > 0.1 && ++ticks < 20000)
    if (coupling.last_result().X_WH.translation.z() > kRadius - 0.4 * mm)
      before_break = coupling.last_result().coupling.force.z();
  EXPECT_GT(before_break, 4);
  EXPECT_LT(coupling.last_result().coupling.force.z(), 0.1);
  EXPECT_LT(std::abs(coupling.last_result().energy.closure()), 1e-3);
}

TEST(Coupling, RestsInBalanceAlsoInTorque) {
  const Tool tool(SphereHead{kRadius}, RayHandle{20 * mm});
  Simulation simulation(half_space(), tool, implicit(1e16));
  CouplingGains gains;
  gains.angular_stiffness = 0.3;
  gains.angular_damping = 2 * std::sqrt(gains.angular_stiffness * gains.inertia);
  VirtualCoupling coupling(simulation, gains);
  const Mat3 tilt = rotation_from_vector({0.3, -0.2, 0});
  const Vec3 head = -(tilt * tool.X_HT().translation);  // handle point when the head's centre is at the origin
  double last = 2 * mm;
  for (int n = 0; n < 3000; ++n) {
    const double z = std::max(2 * mm - 0.05 * n * kTick, kRadius - 2 / gains.stiffness);
    coupling.step({tilt, head + kAside + Vec3(0, 0, z)}, {Vec3(0, 0, (z - last) / kTick), Vec3::Zero()}, kTick);
    last = z;
  }
  const CoupledResult& result = coupling.last_result();
  const Wrench& contact = simulation.last_result().model;
  EXPECT_GT(contact.force.z(), 0.5);
  EXPECT_GT(contact.torque.norm(), 1e-3);
  // At rest the coupling bears the contact, and the tool has rotated against its spring.
  EXPECT_LT((result.coupling.force - contact.force).norm(), 1e-4);
  EXPECT_LT((result.coupling.torque - contact.torque).norm(), 1e-5);
  EXPECT_GT(vector_from_rotation(result.X_WH.rotation * tilt.transpose()).norm(), 1e-3);
  EXPECT_LT(std::abs(result.energy.closure()), 1e-3);
}

// The imbalance is judged by the path of the tool; at rest there is only the rounding of the ledger.
TEST(Coupling, OfAToolAtRestIsInBalance) {
  for (const ToolHead& head : {twist_drill_head(2 * mm, 10 * mm), flame_head(1.4 * mm, 4 * mm, 0.8 * mm, 1.5 * mm)}) {
    Simulation simulation(half_space(4 * mm, presets::cortical_bone()), Tool(head, RayHandle{30 * mm}),
                          implicit(0, std::nullopt));
    VirtualCoupling coupling(simulation, {});
    const double start = 32 * mm, down = 5 * mm, duration = 0.3;  // [m], [s]
    int unsolved = 0;
    for (int n = 1; n <= 2000; ++n) {
      const double time = n * kTick;
      const Vec3 velocity(0, 0, time > duration ? 0 : -down / duration);
      const Pose hand = Pose::from_translation({0, 0, start - down * std::min(1.0, time / duration)});
      const StepStatus status = coupling.step(hand, {velocity, Vec3::Zero()}, kTick).status;
      unsolved += time > 1 && has_any(status, StepStatus::not_in_balance);
    }
    EXPECT_EQ(unsolved, 0);
    EXPECT_GT(coupling.last_result().hand.force.z(), 1);
  }
}

TEST(CouplingGains, RefuseAToolThatWouldRingWithTheLargestThatDoesNot) {
  DeviceCapabilities device = capabilities(device_model("touch"));
  device.damping = 5;
  const double max_mass = 25 / device.stiffness;
  expect_refused([&] { return coupling_gains(device, 0.3); },
                 {("Choose at most " + format_number(max_mass) + " kg").c_str()});
  const CouplingGains gains = coupling_gains(device, 0.999 * max_mass);
  EXPECT_NEAR(gains.damping / (2 * std::sqrt(gains.stiffness * gains.mass)), 0.5, 0.01);
  EXPECT_NEAR(gains.inertia / CouplingGains{}.inertia, gains.mass / CouplingGains{}.mass, 1e-12);
}

TEST(Coupling, NeverPullsWithMoreThanTheDeviceCanRender) {
  Simulation simulation(half_space(), ball(), implicit(1e16));
  CouplingGains gains = touch_gains();
  VirtualCoupling coupling(simulation, gains);
  const PressedTool pressed = press(coupling, 20);
  EXPECT_NEAR(pressed.rest_force, gains.max_force, 1e-6);
  EXPECT_LT(pressed.jitter, 1e-9);
  EXPECT_LT(std::abs(coupling.last_result().energy.closure()), 1e-3);
}

TEST(Coupling, ParksTheToolAndContinuesFromItsPlace) {
  using Rejoin = VirtualCoupling::Rejoin;
  for (const Rejoin rejoin : {Rejoin::near, Rejoin::free}) {
    Simulation simulation(half_space(), ball(), implicit(1e13));
    const CouplingGains gains = touch_gains();
    VirtualCoupling coupling(simulation, gains);
    const auto hand = [&](double height, int ticks) -> const CoupledResult& {
      for (int n = 0; n < ticks; ++n) coupling.step(Pose::from_translation(Vec3(0, 0, kRadius + height)), {}, 1e-3);
      return coupling.last_result();
    };
    hand(2e-4, 10);
    EXPECT_GT(hand(-1e-3, 300).hand.force.z(), 0.3);
    const Pose X_WH = coupling.last_result().X_WH;
    coupling.park(rejoin);
    EXPECT_TRUE(coupling.last_result().hand.force.isZero(0));
    const CoupledResult& far = hand(-3.5e-3, 20);
    EXPECT_EQ(far.status, StepStatus::tool_waits);
    EXPECT_TRUE(far.hand.force.isZero(0));
    EXPECT_EQ(far.X_WH.translation, X_WH.translation);
    const CoupledResult& back = hand(-1e-3, 1);
    EXPECT_EQ(has_any(back.status, StepStatus::tool_waits), rejoin == Rejoin::free);
    EXPECT_LT((back.X_WH.translation - X_WH.translation).norm(), 2e-4);
    EXPECT_EQ(back.hand.force.z() > 0.3, rejoin == Rejoin::near);
    const CoupledResult& free = hand(1e-3, 50);
    EXPECT_FALSE(has_any(free.status, StepStatus::tool_waits));
    EXPECT_NEAR(free.X_WH.translation.z(), kRadius + 1e-3, 1e-4);
  }
}

TEST(CouplingInput, IsRefusedWithItsValueAndTheCure) {
  CouplingGains gains;
  gains.mass = -1;
  expect_refused([&] { validate(gains); }, {"CouplingGains::mass"});
  gains.mass = 50;
  expect_refused([&] { validate(gains); }, {"CouplingGains::mass", "50"});
  gains = {};
  gains.stiffness = 0.7;  // meant in N/mm
  expect_refused([&] { validate(gains); }, {"CouplingGains::stiffness", "0.7"});
  gains = {};
  gains.max_force = NAN;
  expect_refused([&] { validate(gains); }, {"CouplingGains::max_force"});
  Simulation explicit_contact(half_space(), ball());
  expect_refused([&] { VirtualCoupling(explicit_contact, {}); }, {"ContactTime::end"});
  DeviceCapabilities silent;
  silent.model = "silent";
  expect_refused([&] { return coupling_gains(silent); }, {"silent"});
  DeviceCapabilities boasting = capabilities(device_model("touch"));
  boasting.stiffness = 1e6;
  expect_refused([&] { return coupling_gains(boasting); }, {"DeviceCapabilities::stiffness"});
}

// --- Simulation::probe ----------------------------------------------------------------------------------------------

TEST(Probe, SeesWhatTheStepWillFeelAndChangesNothing) {
  for (const ContactTime time : {ContactTime::middle, ContactTime::end}) {
    SimulationConfig config = implicit(1e14);
    config.contact_time = time;
    Simulation probed(half_space(), ball(kSpin), config), plain(half_space(), ball(kSpin), config);
    for (int n = 0; n < 300; ++n) {
      const Pose pose = Pose::from_translation(kAside + Vec3(3e-6 * n, 0, kRadius - 2e-6 * n));
      const Twist velocity = {Vec3(3e-3, 0, -2e-3), Vec3::Zero()};
      const ContactProbe probe = probed.probe(pose, velocity, kTick);
      const StepResult &after_probe = probed.step(pose, velocity, kTick), &without = plain.step(pose, velocity, kTick);
      ASSERT_EQ(after_probe.force, without.force);
      ASSERT_EQ(after_probe.removed_volume, without.removed_volume);
      ASSERT_LT((probe.wrench.force - after_probe.model.force).norm(), 1e-12 + 1e-6 * after_probe.model.force.norm());
      ASSERT_LT((probe.wrench.torque - after_probe.model.torque).norm(), 1e-12 + 1e-6 * mm);
      ASSERT_EQ(probe.contact.voxels, after_probe.contact.voxels);
    }
    EXPECT_GT(plain.last_result().removed_volume, 0);
  }
}

/// The stiffness neglects the rotation of the normals (Gauss-Newton). This rotation reduces the sideways push of every
/// spring, so the sum is a little stiffer than the slope.
TEST(Probe, StiffnessIsTheSlopeOfTheForce) {
  SimulationConfig smooth = implicit(1e14);
  smooth.friction = DryFriction{0, 0, 0};  // because friction has its own stiffness
  Simulation simulation(half_space(), Tool(SphereHead{kRadius}, RayHandle{20 * mm}), smooth);
  const Pose pose = at_height(kRadius + 20 * mm - 0.3 * mm);
  const ContactProbe at = simulation.probe(pose, {}, kTick);
  const auto moved = [&](const Vec3& shift) {
    Simulation fresh(half_space(), simulation.tool(), smooth);
    return fresh.probe(Pose::from_translation(pose.translation + shift), {}, kTick).wrench;
  };
  const double step = 1e-7;
  const Wrench up = moved({0, 0, step}), down = moved({0, 0, -step});
  const double slope = (down.force.z() - up.force.z()) / (2 * step);
  EXPECT_GT(at.stiffness(2, 2), slope);
  EXPECT_LT(at.stiffness(2, 2), 1.05 * slope);
  EXPECT_NEAR(slope, closed_forms::cap_stiffness(1e14, kRadius, 0.3 * mm), 0.02 * slope) << "C2";
  EXPECT_LT((at.stiffness - at.stiffness.transpose()).norm(), 1e-6 * at.stiffness.norm()) << "single precision";
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix<double, 6, 6>> solver(at.stiffness);
  EXPECT_GT(solver.eigenvalues().minCoeff(), -1e-6 * solver.eigenvalues().maxCoeff());
}

TEST(Probe, OfRubbishFeelsNothing) {
  Simulation simulation(half_space(), ball(), implicit(1e14));
  const Pose inside = Pose::from_translation({0, 0, 0.5 * mm});
  EXPECT_GT(simulation.probe(inside, {}, kTick).wrench.force.z(), 1);
  EXPECT_EQ(simulation.probe(inside, {}, NAN).wrench.force, Vec3::Zero());
  Pose rubbish = inside;
  rubbish.rotation *= 2;
  EXPECT_EQ(simulation.probe(rubbish, {}, kTick).wrench.force, Vec3::Zero());
}

// A wheel that falls on enamel at 0.3 m/s is held, even with few Newton steps, and a tick stays within its bound.
TEST(Coupling, DoesAtMostWhatItsWorstCaseSays) {
  for (const int steps : {8, 9, 40}) {
    Simulation simulation(half_space(4 * mm, presets::enamel()),
                          Tool(wheel_head(2.4 * mm, 0.8 * mm, 1 * mm), RayHandle{0}), implicit(0, {}));
    CouplingGains gains = touch_gains();
    gains.newton_steps = steps;
    VirtualCoupling coupling(simulation, gains);
    const double tip = simulation.tool().X_HT().translation.z() + simulation.tool().head().bounding_box().min.z();
    double height = 1 * mm - tip, lowest = height;
    int max_sub_ticks = 0, max_steps = 0;
    for (int n = 0; n < 200; ++n) {
      const double speed = n < 10 ? -0.3 : 0;
      height += speed * kTick;
      const CoupledResult& result =
          coupling.step(Pose::from_translation({0.017 * mm, 0, height}), {{0, 0, speed}, {}}, kTick);
      EXPECT_LE(result.newton_steps + result.sub_ticks, coupling.worst_case().contacts);
      max_sub_ticks = std::max(max_sub_ticks, result.sub_ticks), max_steps = std::max(max_steps, result.newton_steps);
      lowest = std::min(lowest, result.X_WH.translation.z() + tip);
    }
    EXPECT_GE(max_sub_ticks, 6) << steps;
    EXPECT_GE(max_steps, 8) << steps << ": the budget is used";
    EXPECT_GT(lowest, -0.03 * mm) << steps;
    EXPECT_LT(std::abs(coupling.last_result().energy.closure()), 1e-3) << steps;
  }
}

// Velocities in mm/s with poses in metres, or in degrees, made the damper push the tool: it removed 116 times the
// volume.
TEST(Coupling, WaitsWhileVelocitiesSayManyTimesTheWay) {
  struct Result {
    double removed = 0, force = 0;
    int refused = 0;
  };
  const auto drill = [](double unit, double noise) {
    Simulation simulation(half_space(), ball(300), implicit(1e14));
    VirtualCoupling coupling(simulation, touch_gains());
    Result all;
    for (int n = 0; n < 1500; ++n) {
      const double wobble = noise * (n % 2 == 0 ? 1 : -1);
      const Twist given{Vec3(wobble, 0, -2e-3 * unit), Vec3::Zero()};
      const CoupledResult& tick = coupling.step(at_height(kRadius + 0.5 * mm - 2e-6 * n), given, 1e-3);
      all.removed += tick.removed_volume;
      all.force = std::max(all.force, tick.hand.force.norm());
      all.refused += has_any(tick.status, StepStatus::velocity_rejected) ? 1 : 0;
    }
    return all;
  };
  const Result right = drill(1, 0), noisy = drill(1, 0.15), none = drill(0, 0), in_mm = drill(1000, 0);
  EXPECT_GT(right.removed, 0);
  EXPECT_EQ(right.refused + noisy.refused + none.refused, 0);
  EXPECT_NEAR(none.removed / right.removed, 1, 0.1) << "a device may give no velocity";
  EXPECT_NEAR(noisy.removed / right.removed, 1, 0.1);
  EXPECT_GT(in_mm.refused, 1400);
  EXPECT_EQ(in_mm.removed, 0);
  EXPECT_LT(in_mm.force, 1e-9);
}

}  // namespace
}  // namespace hapticut::coupling_test
