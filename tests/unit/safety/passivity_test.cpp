// SPDX-License-Identifier: Apache-2.0
// The account of energy between a model and a hand.
#include "hapticut/safety/passivity.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <deque>
#include <optional>

#include "support/guarded_loop.hpp"

namespace hapticut::passivity_test {
namespace {

constexpr double kStiffness = 700, kPeak = 3.3, kTick = 1e-3;  // [N/m], [N], [s] values of a Touch

PassivityOptions options_of_touch() {
  PassivityOptions options;
  options.stiffness = kStiffness;
  options.max_damping = 3;
  return options;
}

/// Controls a force without torque.
Vec3 control(PassivityController& controller, const Vec3& force, const Vec3& effects, const Vec3& applied,
             const Vec3& motion, std::optional<double> stored = {}, std::optional<double> motor = {}) {
  return controller.control({{force}, {effects}, {applied}, motion, Vec3::Zero(), kTick, stored, motor}).force;
}

/// Outcome of a hand that moves at 0.1 m/s into a wall and out again, three times.
struct Outcome {
  double given = 0;        // [J] work given to the hand
  double max_damping = 0;  // [N]
  double pulled = 0;       // [N] maximum force inwards
};

/// @param late  [ticks] delay from writing a force to its effect, in addition to the hold of one tick
Outcome press(PassivityController& controller, double stiffness, int late) {
  constexpr double kSpeed = 0.1;
  const double depth = 0.9 * kPeak / kStiffness;
  std::deque<Vec3> delayed(std::size_t(late) + 1, Vec3::Zero());
  Outcome seen;
  Vec3 applied = Vec3::Zero();
  double last = 1e-3;
  for (int n = 0; n < 3 * 200; ++n) {
    const double t = (n % 200) * kTick;  // from 1 mm above down to the depth, and up again
    const double down = 1e-3 - kSpeed * t, up = -depth + kSpeed * (t - (1e-3 + depth) / kSpeed);
    const double height = std::min(down > -depth ? down : up, 8e-3);
    const Vec3 force(0, 0, std::max(0.0, -stiffness * height)), motion(0, 0, height - last);
    seen.given += delayed.front().dot(motion);
    applied = control(controller, force, Vec3::Zero(), applied, motion);
    delayed.pop_front();
    delayed.push_back(applied);
    seen.max_damping = std::max(seen.max_damping, controller.damping_force());
    seen.pulled = std::max(seen.pulled, -applied.z());
    last = height;
  }
  return seen;
}

TEST(PassivityController, LeavesASpringAloneThatTheDeviceRenders) {
  for (const double stiffness : {100.0, 350.0, kStiffness}) {
    PassivityController controller(options_of_touch(), kPeak);
    const Outcome seen = press(controller, stiffness, 0);
    EXPECT_LT(seen.max_damping, 1e-9) << stiffness;
    EXPECT_EQ(seen.pulled, 0);
  }
}

TEST(PassivityController, RemovesTheEnergyThatAStifferSpringGives) {
  PassivityOptions off = options_of_touch();
  off.enabled = false;
  PassivityController watches_nothing(off, kPeak), watches(options_of_touch(), kPeak);
  const double stiff = 4 * kStiffness;
  const Outcome bare = press(watches_nothing, stiff, 0), damped = press(watches, stiff, 0);
  EXPECT_GT(bare.given, 1e-3);  // k v T times the depth, three times
  EXPECT_LT(damped.given, 0.9 * bare.given);
  EXPECT_GT(damped.max_damping, 0);
}

TEST(PassivityController, LeavesAForceThatIsLateByAKnownTimeAlone) {
  for (const int late : {1, 2, 3}) {
    PassivityOptions knows = options_of_touch();
    knows.delay = late;
    PassivityController knows_of_it(knows, kPeak), knows_nothing(options_of_touch(), kPeak);
    EXPECT_LT(press(knows_of_it, kStiffness, late).max_damping, 1e-9) << late;
    EXPECT_LT(press(knows_nothing, kStiffness, late).max_damping, 1e-9)
        << "the controller only sees the force that it wrote";
  }
}

TEST(PassivityController, LeavesWeightAndVibrationOutOfTheAccount) {
  for (const bool says : {true, false}) {
    PassivityController controller(options_of_touch(), kPeak);
    const Vec3 weight(0, 0, -0.5), touch(0, 0, 0.1);
    Vec3 applied = Vec3::Zero();
    double max_damping = 0;
    for (int n = 0; n < 50; ++n) {  // the weight pushes the hand down
      applied = control(controller, weight + touch, says ? weight : Vec3(Vec3::Zero()), applied, Vec3(0, 0, -1e-4));
      max_damping = std::max(max_damping, controller.damping_force());
    }
    EXPECT_EQ(max_damping == 0, says);
  }
}

TEST(PassivityController, DiscardsEnergyThatTheModelHasNotStored) {
  for (const bool says : {true, false}) {
    PassivityOptions options = options_of_touch();
    options.max_damping = 0;  // no bound
    PassivityController controller(options, kPeak);
    const std::optional<double> stored = says ? std::optional(1e-4) : std::nullopt;
    const Vec3 resists(0, 0, 1);
    for (int n = 0; n < 1000; ++n)  // a cut of 10 mm dissipates 10 mJ
      (void)control(controller, resists, Vec3::Zero(), resists, Vec3(0, 0, -1e-5), stored);
    EXPECT_NEAR(controller.stored(), says ? 1e-4 : 10e-3, 5e-5);
    Vec3 applied = resists;
    double given = 0;
    for (int n = 0; n < 500; ++n) {  // the same force along the motion: a model that pushes
      const Vec3 motion(0, 0, 1e-5);
      given += applied.dot(motion);
      applied = control(controller, resists, Vec3::Zero(), applied, motion, stored);
    }
    EXPECT_EQ(controller.damping_force() > 0, says);
    if (says) {
      EXPECT_LT(given, 4e-3);
    } else {
      EXPECT_NEAR(given, 5e-3, 1e-6);
    }
  }
}

// The work of a force along the hand's motion is limited to the motor work that the model reports, plus k dx^2/2 per
// tick of a spring whose force is held. What the hand gets before the force is reduced, it gives back to the damping.
TEST(PassivityController, LimitsAPushToTheWorkOfTheMotor) {
  const Vec3 on(0, 0, 1e-4);  // a tick
  for (const double paid : {0.0, 0.5, 1.0}) {
    PassivityController controller(options_of_touch(), kPeak);
    Vec3 applied = Vec3::Zero();
    double given = 0, motor = 0, held = 0, most_ahead = 0;  // [J]
    for (int n = 0; n < 2000; ++n) {
      const Vec3 pushes(0, 0, std::min(1.0, 0.01 * n));
      given += applied.dot(on);
      applied = control(controller, pushes, Vec3::Zero(), applied, on, 1.0, paid * pushes.dot(on));
      motor += paid * pushes.dot(on);
      held += 0.5 * kStiffness * on.squaredNorm();
      most_ahead = std::max(most_ahead, given - motor - held);
    }
    EXPECT_LE(most_ahead, 1e-3) << paid;  // [J] for a push that grows to 1 N within 10 mm
    EXPECT_LE(given, motor + held + 1e-6) << paid;
    EXPECT_GE(given, 0.9 * motor) << paid;
  }
}

// A smooth force stays smooth, whatever the hand does and whether or not the motor pays, at every rate.
TEST(PassivityController, ChangesASmoothForceByLittleInATick) {
  for (const double rate : {250.0, 500.0, 1000.0, 4000.0, 8000.0})
    for (const double step : {0.0, 5e-6, 55e-6})  // [m] step of the encoders
      for (const bool knows : {false, true}) {
        PassivityController controller(options_of_touch(), kPeak);
        Vec3 applied = Vec3::Zero(), before = Vec3::Zero(), last = Vec3::Zero(), was = Vec3::Zero();
        double most = 0;
        for (int n = 0; n < int(3 * rate); ++n) {
          const double t = n / rate;
          Vec3 at = 5e-3 * Vec3(std::sin(7 * t), std::cos(5 * t), 0.3 * std::sin(11 * t));
          if (step > 0) at = step * (at / step).array().floor().matrix();
          const Vec3 force = std::min(1.0, t) * Vec3(std::cos(4 * t), 0.5 * std::sin(3 * t), 1 + std::sin(6 * t));
          applied = controller
                        .control({{force},
                                  {},
                                  {applied},
                                  n > 0 ? Vec3(at - before) : Vec3(Vec3::Zero()),
                                  Vec3::Zero(),
                                  1 / rate,
                                  1e-4,
                                  knows ? std::optional(0.0) : std::nullopt})
                        .force;
          if (n > 0) most = std::max(most, (applied - last).norm() - (force - was).norm());
          before = at;
          last = applied;
          was = force;
        }
        EXPECT_LE(most, step > 5e-5 ? 0.025 : 0.02) << rate << " Hz, steps of " << step << ", motor known: " << knows;
        EXPECT_GT(most, 0) << "the controller does nothing";
      }
}

// A spring and a damper couple a light tool to a hand whose encoders have steps of 55 um. The response to each step
// acts after the hand has passed the step.
TEST(PassivityController, LeavesTheStepsOfEncodersAlone) {
  constexpr double kStep = 55e-6, kDamper = 4, kMass = 5e-3;  // [m], [N s/m], [kg]
  for (const double speed : {2e-3, 5e-3, 10e-3, 20e-3, 40e-3}) {
    PassivityController controller(options_of_touch(), kPeak);
    Vec3 applied = Vec3::Zero();
    double max_damping = 0, before = 0, tool = 0, tool_speed = 0;
    for (int n = 1; n < 2000; ++n) {
      const double hand = kStep * std::floor(speed * n * kTick / kStep), hand_speed = (hand - before) / kTick;
      const double force = (kStiffness * (hand - tool) + kDamper * (hand_speed - tool_speed)) /
                           (1 + kTick * (kDamper + kStiffness * kTick) / kMass);  // at the end of the tick
      tool_speed += kTick * force / kMass;
      tool += kTick * tool_speed;
      applied = control(controller, Vec3(-force, 0, 0), Vec3::Zero(), applied, Vec3(hand - before, 0, 0),
                        0.5 * kStiffness * (hand - tool) * (hand - tool) + 0.5 * kMass * tool_speed * tool_speed);
      max_damping = std::max(max_damping, controller.damping_force());
      before = hand;
    }
    EXPECT_LT(max_damping, 1e-9) << speed;
  }
}

// The hand pivots about a fixed tip: the works of force and torque cancel.
TEST(PassivityController, CountsForceAndTorqueInOneAccount) {
  constexpr double kLength = 0.05, kAngle = 1e-3;  // [m], [rad] per tick
  PassivityController controller(options_of_touch(), kPeak, 0.02, 0.1);
  const Vec3 rotation(0, kAngle, 0), motion = rotation.cross(Vec3(0, 0, kLength));
  Wrench held{Vec3(1, 0, 0), Vec3(0, -kLength, 0)};  // wrench of a force at the tip
  for (int n = 0; n < 500; ++n) {
    const Wrench given = controller.control({held, {}, held, motion, rotation, kTick, 0.0});
    EXPECT_EQ(controller.damping_force(), 0);
    EXPECT_TRUE(given.force == held.force && given.torque == held.torque);
  }
  held.torque.setZero();  // now the force pushes along the hand's motion
  Wrench given;
  for (int n = 0; n < 50; ++n) given = controller.control({held, {}, held, motion, rotation, kTick, 0.0});
  EXPECT_LT(given.force.x(), 1);
  EXPECT_LT(given.torque.y(), 0);
}

// A hand that pivots about the tip, through the guard of a device that renders torque.
TEST(Guard, LeavesAHandAloneThatPivotsAboutTheTip) {
  constexpr double kLength = 0.05, kAngle = 1e-4;  // [m], [rad] per tick
  test::GuardedLoop loop({}, "premium6dof");
  loop.reading.valid = true;
  loop.contact.stored = 0;
  double angle = 0;
  const auto tick = [&](const Wrench& wrench) {
    loop.reading.X_BS.rotation = Eigen::AngleAxisd(angle, Vec3::UnitY()).toRotationMatrix();
    loop.reading.X_BS.translation = loop.reading.X_BS.rotation * Vec3(0, 0, kLength);
    return Vec3(loop.tick(wrench.force, wrench.torque).force - wrench.force).norm();
  };
  tick({});
  loop.engage();
  Wrench at_tip{Vec3(0.4, 0, 0), Vec3(0, -0.4 * kLength, 0)};
  for (int n = 0; n < 200; ++n) tick(at_tip);  // as fast as force may grow
  const auto pivot = [&] {                     // [N] largest change of the force
    double change = 0;
    for (int n = 0; n < 300; ++n) {
      angle += kAngle;
      change = std::max(change, tick(at_tip));
    }
    return change;
  };
  EXPECT_EQ(pivot(), 0);
  at_tip.torque.setZero();  // now the force pushes along the hand's motion
  EXPECT_GT(pivot(), 0.01);
}

TEST(PassivityController, ClosesTheAccountWithTheLastForce) {
  PassivityController controller(options_of_touch(), kPeak);
  const Vec3 pushes(0, 0, 1), out(0, 0, 1e-4);
  for (int n = 0; n < 20; ++n) (void)control(controller, pushes, Vec3::Zero(), pushes, out);
  EXPECT_LT(controller.stored(), 0);
  const double damped = controller.damping_force();
  EXPECT_GT(damped, 0);
  EXPECT_LT(control(controller, Vec3::Zero(), Vec3::Zero(), pushes, out).norm(), damped);
  EXPECT_EQ(controller.stored(), 0);
  for (int n = 0; n < 20; ++n) (void)control(controller, Vec3::Zero(), Vec3::Zero(), Vec3::Zero(), out);
  EXPECT_EQ(controller.damping_force(), 0);
}

}  // namespace
}  // namespace hapticut::passivity_test
