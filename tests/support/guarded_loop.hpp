// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <gtest/gtest.h>

#include "hapticut/device/simulated/device_models.hpp"
#include "hapticut/safety/guard.hpp"

namespace hapticut::test {

inline constexpr double kPeriod = 1e-3;  // [s]

/// A simulated device that stands for a real one, whose hand trembles.
inline DeviceCapabilities real_device(const char* model) {
  DeviceCapabilities device = capabilities(device_model(model));
  device.simulated = false;
  return device;
}

/// A guard whose readings have regular time stamps. It limits the forces of a test.
class GuardedLoop {
 public:
  explicit GuardedLoop(const GuardOptions& options = {}, const char* device = "touch")
      : guard(real_device(device), options) {
    guard.start();
  }
  Wrench tick(const Vec3& force = Vec3::Zero(), double period = kPeriod) { return tick(force, Vec3::Zero(), period); }
  Wrench tick(const Vec3& force, const Vec3& torque, double period = kPeriod) {
    reading.time += period;
    ++reading.sequence;
    guard.admit(reading);
    return guard.limit({force, torque}, contact);
  }
  /// Runs until the full force is allowed.
  void engage() {
    for (int n = 0; n < 5000 && guard.state() != ArmingState::on; ++n) tick();
    ASSERT_EQ(guard.state(), ArmingState::on);
  }
  /// Runs with 1 N until the guard passes the full force.
  void push() {
    for (int n = 0; n < 10; ++n) tick({0, 0, 1});
    EXPECT_NEAR(tick({0, 0, 1}).force.z(), 1, 1e-12);
  }
  /// Pushes for 100 ticks: no force may pass, and the guard waits until the tool is free.
  void expect_no_force_until_free() {
    for (int n = 0; n < 100; ++n) {
      EXPECT_TRUE(tick({0, 0, 1}).force.isZero(0));
      EXPECT_EQ(guard.state(), ArmingState::wait_free);
    }
    engage();
    push();
  }
  [[nodiscard]] std::uint64_t count(SafetyEvent event) const { return guard.log().count(event); }

  SafetyGuard guard;
  DeviceState reading;
  ModelContact contact;
};

}  // namespace hapticut::test
