// SPDX-License-Identifier: Apache-2.0
// All parts of a run use GuardOptions::period as the period.
#include <gtest/gtest.h>

#include <cmath>
#include <string>
#include <vector>

#include "device/angular_velocity_estimate.hpp"
#include "hapticut/core/errors.hpp"
#include "hapticut/device/simulated/mock.hpp"
#include "hapticut/device/simulated/mouse.hpp"
#include "hapticut/device/simulated/playback.hpp"

namespace hapticut::period_test {
namespace {

constexpr double kRates[] = {100, 250, 500, 1000, 2000, 4000};  // [Hz]

RunOptions at(double rate, double seconds) {
  RunOptions options;
  options.simulated_time = true;
  options.stop_on_signals = false;
  options.seconds = seconds;
  options.guard.period = 1 / rate;
  return options;
}

TEST(Period, AHandPressesTheSameWallAtEveryRateWithDefaultOptions) {
  constexpr double kStiffness = 300, kSeconds = 4;  // [N/m], [s]
  MockOptions held;
  held.path = scripted_path("press");
  held.device = device_model("touch");
  held.hand = hand_model("nominal");
  held.rigid = held.dry_friction = held.encoder = false;
  // At rest the spring of the hand, with a set point 5 mm below the surface, balances the spring of the wall.
  const double depth = 5e-3 * held.hand.stiffness / (held.hand.stiffness + kStiffness);
  for (const double rate : kRates) {
    MockDevice device(held);
    DeviceState last;
    const RunReport report = device.run(
        [&](const DeviceState& state) {
          last = state;
          const double height = state.X_BS.translation.z();
          DeviceCommand command;
          command.wrench.force.z() = std::max(0.0, -kStiffness * height);
          command.contact.touching = height < 0;
          return command;
        },
        at(rate, kSeconds));
    EXPECT_EQ(report.period, 1 / rate);
    EXPECT_NEAR(last.time, double(report.ticks - 1) / rate, 1e-9) << rate;
    EXPECT_NEAR(last.time, kSeconds, 1 / rate + 1e-9) << rate;
    EXPECT_NEAR(last.X_BS.translation.z(), -depth, 1e-3 * depth) << rate;
    EXPECT_NEAR(device.output().applied.force.z(), kStiffness * depth, 1e-3 * kStiffness * depth) << rate;
    EXPECT_EQ(report.arming, ArmingState::on) << rate;
    EXPECT_EQ(device.plant().options().period, 1 / rate);
    EXPECT_TRUE(report.warnings.empty());
  }
}

TEST(Period, TheForceIsFadedInAndOutInTheSameTimeAtEveryRate) {
  for (const double rate : kRates) {
    MockOptions options;
    options.path = scripted_path("rest");
    MockDevice device(options);
    double engaged = 0;
    const RunReport report = device.run(
        [&](const DeviceState& state) {
          if (engaged == 0 && device.last_arming() == ArmingState::on) engaged = state.time;
          DeviceCommand command;
          command.wrench.force.x() = 0.1;
          command.contact.touching = false;
          return command;
        },
        at(rate, 2));
    const GuardOptions guard;
    const double waits = (guard.arming.valid_ticks + guard.arming.free_ticks) / rate;
    EXPECT_NEAR(engaged, guard.arming.ramp + waits, 3 / rate) << rate;
    EXPECT_EQ(report.arming, ArmingState::on);
  }
}

TEST(Period, AMouseMovesAtTheSameSpeedAtEveryRate) {
  for (const double rate : kRates) {
    MouseDevice mouse;
    double x = 0;
    mouse.key(MoveKey::right, true);
    (void)mouse.run(
        [&](const DeviceState& state) {
          x = state.X_BS.translation.x();
          return DeviceCommand{};
        },
        at(rate, 1));
    EXPECT_NEAR(x, MouseOptions{}.key_speed, 0.02 * MouseOptions{}.key_speed) << rate;
  }
}

TEST(Period, ReadingsThatAreBadOrStandStillAreBorneForATimeAndNotForATickCount) {
  for (const double rate : kRates) {
    PoseGate gate({}, {});
    SafetyLog log;
    DeviceState reading;
    const auto check = [&] {
      ++reading.sequence;
      return gate.check(reading, 1 / rate, log);
    };
    (void)check();
    reading.valid = false;
    double held = 0;
    while (check() == PoseGate::Verdict::held) held += 1 / rate;
    EXPECT_NEAR(held, PoseGateOptions{}.hold, 1 / rate) << rate;

    gate.restart();
    reading.valid = true;
    reading.velocity.linear.x() = 0.1;  // reported, but the position does not change
    double believed = 0;
    while (check() == PoseGate::Verdict::accepted) believed += 1 / rate;
    EXPECT_NEAR(believed, PoseGateOptions{}.frozen, 1 / rate + 1e-9) << rate;
  }
}

TEST(Period, ReadingsThatArePlayedBackKeepTheirOwnAndSaySo) {
  std::vector<DeviceState> readings(400);
  for (std::size_t n = 0; n < readings.size(); ++n) {
    readings[n].time = 0.5e-3 * double(n);
    readings[n].sequence = n + 1;
  }
  PlaybackDevice device(readings, {});
  const DeviceCallback rests = [](const DeviceState&) { return DeviceCommand{}; };
  const RunReport other = device.run(rests, at(1000, 0));
  EXPECT_NEAR(other.period, 0.5e-3, 1e-9);
  ASSERT_EQ(other.warnings.size(), 1U);
  EXPECT_NE(other.warnings[0].find("0.001 s became 0.0005"), std::string::npos) << other.warnings[0];
  EXPECT_TRUE(device.run(rests, at(2000, 0)).warnings.empty());
}

TEST(AngularVelocityEstimate, IsRightAtEveryRateAndWithMissingReadings) {
  constexpr double kSpeed = 2;  // [rad/s]
  for (const double rate : kRates)
    for (const int every : {1, 3}) {  // the other readings are missing or late
      AngularVelocityEstimate estimate;
      Vec3 speed = Vec3::Zero();
      for (int n = 0; n < int(rate); n += n % 2 == 0 ? every : 1)
        speed = estimate.update(rotation_from_vector(Vec3(0, 0, kSpeed * n / rate)), n / rate);
      EXPECT_NEAR(speed.z(), kSpeed, 1e-3) << rate << " Hz, " << every;
      EXPECT_EQ(estimate.update(rotation_from_vector(Vec3(0, 0, 1)), 0).z(), speed.z()) << "time does not go back";
    }
}

}  // namespace
}  // namespace hapticut::period_test
