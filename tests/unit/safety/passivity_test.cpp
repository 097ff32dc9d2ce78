// SPDX-License-Identifier: Apache-2.0
// The account of energy between a model and a hand.
#include "hapticut/safety/passivity.hpp"

#include <gtest/gtest.h>

#include <deque>

namespace hapticut::passivity_test {
namespace {

constexpr double kStiffness = 700, kPeak = 3.3, kTick = 1e-3;  // [N/m], [N], [s] of a Touch

PassivityOptions options_of_touch() {
  PassivityOptions options;
  options.stiffness = kStiffness;
  options.greatest_damping = 3;
  return options;
}

/// A hand at 0.1 m/s into a wall and out again, three times.
struct Pressed {
  double given = 0;   // [J] to the hand
  double taken = 0;   // [N] most damping
  double pulled = 0;  // [N] inwards
};

/// @param late  [ticks] between a written force and the one that acts, beyond the hold
Pressed press(PassivityController& controller, double stiffness, int late) {
  constexpr double kSpeed = 0.1;
  const double depth = 0.9 * kPeak / kStiffness;
  std::deque<Vec3> under_way(std::size_t(late) + 1, Vec3::Zero());
  Pressed seen;
  Vec3 applied = Vec3::Zero();
  double last = 1e-3;
  for (int n = 0; n < 3 * 200; ++n) {
    const double t = (n % 200) * kTick;  // 1 mm above, down to the depth, and up again
    const double down = 1e-3 - kSpeed * t, up = -depth + kSpeed * (t - (1e-3 + depth) / kSpeed);
    const double height = std::min(down > -depth ? down : up, 8e-3);
    const Vec3 force(0, 0, std::max(0.0, -stiffness * height)), motion(0, 0, height - last);
    seen.given += under_way.front().dot(motion);
    applied = controller.control({force, Vec3::Zero(), applied, motion, kTick, {}});
    under_way.pop_front();
    under_way.push_back(applied);
    seen.taken = std::max(seen.taken, controller.taken());
    seen.pulled = std::max(seen.pulled, -applied.z());
    last = height;
  }
  return seen;
}

TEST(PassivityController, LeavesASpringAloneThatTheDeviceRenders) {
  for (const double stiffness : {100.0, 350.0, kStiffness}) {
    PassivityController controller(options_of_touch(), kPeak);
    const Pressed seen = press(controller, stiffness, 0);
    EXPECT_LT(seen.taken, 1e-9) << stiffness;
    EXPECT_EQ(seen.pulled, 0);
  }
}

TEST(PassivityController, TakesOutWhatAStifferSpringGives) {
  PassivityOptions off = options_of_touch();
  off.enabled = false;
  PassivityController watches_nothing(off, kPeak), watches(options_of_touch(), kPeak);
  const double stiff = 4 * kStiffness;
  const Pressed bare = press(watches_nothing, stiff, 0), damped = press(watches, stiff, 0);
  EXPECT_GT(bare.given, 1e-3);  // k v T of the depth, three times
  EXPECT_LT(damped.given, 0.9 * bare.given);
  EXPECT_GT(damped.taken, 0);
}

TEST(PassivityController, LeavesAForceThatIsLateByAKnownTimeAlone) {
  for (const int late : {1, 2, 3}) {
    PassivityOptions knows = options_of_touch();
    knows.delay = late;
    PassivityController knows_of_it(knows, kPeak), knows_nothing(options_of_touch(), kPeak);
    EXPECT_LT(press(knows_of_it, kStiffness, late).taken, 1e-9) << late;
    EXPECT_LT(press(knows_nothing, kStiffness, late).taken, 1e-9) << "it sees what it wrote";
  }
}

TEST(PassivityController, LeavesWeightAndVibrationOutOfTheAccount) {
  for (const bool says : {true, false}) {
    PassivityController controller(options_of_touch(), kPeak);
    const Vec3 weight(0, 0, -0.5), touch(0, 0, 0.1);
    Vec3 applied = Vec3::Zero();
    double taken = 0;
    for (int n = 0; n < 50; ++n) {  // the hand gives way to the weight
      applied = controller.control(
          {weight + touch, says ? weight : Vec3(Vec3::Zero()), applied, Vec3(0, 0, -1e-4), kTick, {}});
      taken = std::max(taken, controller.taken());
    }
    EXPECT_EQ(taken == 0, says);
  }
}

TEST(PassivityController, ForgetsWhatTheModelHasNotStored) {
  for (const bool says : {true, false}) {
    PassivityOptions options = options_of_touch();
    options.greatest_damping = 0;  // no bound
    PassivityController controller(options, kPeak);
    const std::optional<double> stored = says ? std::optional(1e-4) : std::nullopt;
    const Vec3 resists(0, 0, 1);
    for (int n = 0; n < 1000; ++n)  // a cut of 10 mm: 10 mJ that are gone
      (void)controller.control({resists, Vec3::Zero(), resists, Vec3(0, 0, -1e-5), kTick, stored});
    EXPECT_NEAR(controller.stored(), says ? 1e-4 : 10e-3, 5e-5);
    Vec3 applied = resists;
    double given = 0;
    for (int n = 0; n < 500; ++n) {  // the same force along the motion: a model that pushes
      const Vec3 motion(0, 0, 1e-5);
      given += applied.dot(motion);
      applied = controller.control({resists, Vec3::Zero(), applied, motion, kTick, stored});
    }
    EXPECT_EQ(controller.taken() > 0, says);
    if (says) {
      EXPECT_LT(given, 4e-3);
    } else {
      EXPECT_NEAR(given, 5e-3, 1e-6);
    }
  }
}

// Where the model says what its motor gave, a force that pushes the hand on is given as far as that and the spring go.
TEST(PassivityController, GivesOfAPushWhatTheMotorPaysFor) {
  const Vec3 pushes(0, 0, 1), on(0, 0, 1e-4);  // 0.1 mJ a tick
  for (const double paid : {0.0, 0.5, 1.0}) {
    PassivityController controller(options_of_touch(), kPeak);
    Vec3 applied = Vec3::Zero();
    double given = 0, motor = 0, held = 0;  // [J]
    for (int n = 0; n < 100; ++n) {
      given += applied.dot(on);
      applied = controller.control({pushes, Vec3::Zero(), applied, on, kTick, 1.0, paid * pushes.dot(on)});
      motor += paid * pushes.dot(on);
      held += 0.5 * kStiffness * on.squaredNorm();
      EXPECT_GE(applied.z(), 0) << "no more is taken than pushes";
    }
    EXPECT_LE(given, motor + held + 1e-12) << paid;
    EXPECT_GE(given, 0.9 * std::min(1.0, paid) * 100 * pushes.dot(on)) << paid;
  }
}

TEST(PassivityController, ClosesTheAccountWithTheLastForce) {
  PassivityController controller(options_of_touch(), kPeak);
  const Vec3 pushes(0, 0, 1), out(0, 0, 1e-4);
  for (int n = 0; n < 20; ++n) (void)controller.control({pushes, Vec3::Zero(), pushes, out, kTick, {}});
  EXPECT_LT(controller.stored(), 0);
  EXPECT_TRUE(controller.control({Vec3::Zero(), Vec3::Zero(), pushes, out, kTick, {}}).isZero(0));
  EXPECT_EQ(controller.stored(), 0);
}

}  // namespace
}  // namespace hapticut::passivity_test
