// SPDX-License-Identifier: Apache-2.0
// What the guard makes of what a model says of its contact.
#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "hapticut/device/simulated/device_models.hpp"
#include "hapticut/safety/guard.hpp"

namespace hapticut::model_contact_test {
namespace {

constexpr double kPeriod = 1e-3;

TEST(Guard, ArmsOnContactWhateverTheForceIs) {
  const Wrench weight{Vec3(0, 0, -3), Vec3::Zero()};
  for (const bool touching : {false, true}) {
    SafetyGuard guard(capabilities(device_model("touch")), {});
    guard.start();
    DeviceState reading;
    ModelContact contact;
    contact.touching = touching;
    contact.effects = weight;
    for (int n = 0; n < 3000; ++n) {
      reading.time = ++reading.sequence * kPeriod;
      guard.admit(reading);
      (void)guard.release(touching ? Wrench{} : weight, contact);
    }
    EXPECT_EQ(guard.state(), touching ? ArmingState::wait_free : ArmingState::on);
  }
}

TEST(Guard, IsNotHurtByNumbersThatAreNone) {
  constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
  SafetyGuard guard(capabilities(device_model("touch")), {});
  guard.start();
  DeviceState reading;
  ModelContact contact;
  contact.touching = false;
  contact.effects.force.setConstant(kNan);
  contact.stored = kNan;
  Wrench given;
  for (int n = 0; n < 3000; ++n) {
    reading.time = ++reading.sequence * kPeriod;
    reading.X_BS.translation.z() = 1e-3 * std::sin(0.01 * n);
    guard.admit(reading);
    given = guard.release({Vec3(0, 0, 1), Vec3::Zero()}, contact);
    ASSERT_TRUE(given.force.allFinite() && given.force.norm() <= guard.greatest_force()) << n;
  }
  EXPECT_EQ(guard.state(), ArmingState::on);
}

}  // namespace
}  // namespace hapticut::model_contact_test
