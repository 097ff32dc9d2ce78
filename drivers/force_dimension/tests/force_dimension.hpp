// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <dhdsim.h>
#include <gtest/gtest.h>

#include <array>
#include <functional>
#include <vector>

#include "hapticut/device/force_dimension.hpp"
#include "support/device_runs.hpp"

/// @file
/// Runs of devices of Force Dimension against the stand-in, in simulated time with the test as the clock.
namespace hapticut::test {

// Numbers of the library for its devices and errors.
inline constexpr int kOmega3 = 33, kOmega6 = 34, kOmega7 = 35, kFalcon = 60, kCustom = 91, kSigma7 = 104,
                     kSigma7Left = 105;
inline constexpr int kErrorCom = 2, kErrorTimeout = 7, kErrorNotReady = 12, kErrorInvalid = 21;

/// A vector of the base in the frame of the library: x towards the user, y to the right, z up.
inline std::array<double, 3> in_library(const Vec3& v_B) { return {v_B.z(), v_B.x(), v_B.y()}; }

/// Sets pose and twist of a device, both in the base.
inline void place_omega(int device, const Pose& X_BS, const Twist& velocity = {}) {
  // Columns: right, up, towards the user, in the frame of the library.
  Mat3 R_DB;
  R_DB << 0, 0, 1, 1, 0, 0, 0, 1, 0;
  const Mat3 R = R_DB * X_BS.rotation * R_DB.transpose();
  const std::array<double, 9> rows = {R(0, 0), R(0, 1), R(0, 2), R(1, 0), R(1, 1), R(1, 2), R(2, 0), R(2, 1), R(2, 2)};
  dhdsim_set_pose(device, in_library(X_BS.translation).data(), rows.data());
  dhdsim_set_velocity(device, in_library(velocity.linear).data(), in_library(velocity.angular).data());
}

/// The wrench that the amplifiers render, in the base.
inline Wrench rendered_wrench(int device) {
  std::array<double, 3> f{}, t{};
  dhdsim_get_committed_force(device, f.data(), t.data());
  return {Vec3(f[1], f[2], f[0]), Vec3(t[1], t[2], t[0])};
}
inline Wrench rendered_wrench(int device, long n) {
  std::array<double, 3> f{}, t{};
  dhdsim_get_committed(device, n, f.data(), t.data());
  return {Vec3(f[1], f[2], f[0]), Vec3(t[1], t[2], t[0])};
}

/// Checks the state after every run.
inline void expect_safe(int device) {
  const dhdsim_counters c = dhdsim_get_counters(device);
  EXPECT_EQ(c.zero_force_before_off, 1);
  EXPECT_EQ(c.force_on, 0);
  EXPECT_EQ(c.brakes_on, 1);
  EXPECT_EQ(c.brakes_commanded, 1);
  EXPECT_EQ(c.expert_mode, 0);
  EXPECT_EQ(c.expert_mode_violations, 0);
  EXPECT_TRUE(rendered_wrench(device).force.isZero(0));
}

/// Runs in simulated time, by the clock of the stand-in.
class ForceDimensionRuns {
 public:
  /// Options with the clock of the stand-in, which advances by 1 ms before each reading.
  ForceDimensionOptions options_for(const std::string& name = "") {
    ForceDimensionOptions options;
    options.device_name = name;
    options.clock = [this] {
      dhdsim_advance(1e-3);
      if (before_reading_) before_reading_(tick_++);
      return dhdsim_time();
    };
    return options;
  }

  /// `before_reading` is called with the number of the tick.
  RunReport run(Device& device, const DeviceCallback& callback, RunOptions options = quick(),
                const std::function<void(long tick)>& before_reading = nullptr) {
    tick_ = 0;
    before_reading_ = before_reading;
    options.simulated_time = true;
    return device.run(callback, options);
  }

 private:
  long tick_ = 0;
  std::function<void(long tick)> before_reading_;
};

class ForceDimensionTest : public testing::Test, protected ForceDimensionRuns {
 protected:
  void SetUp() override { dhdsim_reset(); }
  void TearDown() override { dhdsim_reset(); }

  static int add(int type, int serial = 1234) {
    const dhdsim_device device = dhdsim_device_of(type, serial);
    return dhdsim_add_device(&device);
  }

  /// Whether one of the sentences contains the words.
  static bool says(const std::vector<std::string>& sentences, const std::string& words) {
    for (const std::string& sentence : sentences)
      if (sentence.find(words) != std::string::npos) return true;
    return false;
  }
};

}  // namespace hapticut::test
