// SPDX-License-Identifier: Apache-2.0
#include "hapticut/device/force_dimension.hpp"

#include <gtest/gtest.h>

#include <string>

#include "force_dimension/tests/force_dimension.hpp"
#include "hapticut/core/errors.hpp"
#include "support/refusal.hpp"

// The library's header has a type of this name at global scope. If our header included it, this would not compile.
enum class uchar { red, green, blue };

namespace hapticut::force_dimension_test {
namespace {

using namespace test;

class ForceDimension : public ForceDimensionTest {};

std::string refusal(const ForceDimensionOptions& options) {
  return test::refusal([&] { return open_force_dimension(options); });
}

TEST_F(ForceDimension, OpensTheFirstDeviceAndReadsItsCapabilities) {
  EXPECT_NE(uchar::red, uchar::green);
  add(kOmega6);
  const auto device = open_force_dimension(options_for());
  const DeviceCapabilities& c = device->capabilities();
  EXPECT_EQ(c.model, "omega.6 (stand-in)");
  EXPECT_EQ(c.serial_number, "1234");
  EXPECT_EQ(c.driver_version, "3.17.5.0");
  EXPECT_EQ(c.input_degrees_of_freedom, 6);
  EXPECT_EQ(c.output_degrees_of_freedom, 3) << "its wrist has sensors and no motors";
  EXPECT_EQ(c.peak_force, 12);
  EXPECT_EQ(c.peak_torque, 0);
  EXPECT_EQ(c.stiffness, 5000);
  EXPECT_EQ(c.damping, 30);
  EXPECT_GT(c.workspace_high.minCoeff(), 0.075) << "the arm reaches farther than the documented workspace";
  EXPECT_LT(c.workspace_high.maxCoeff(), 0.15);
  EXPECT_EQ(c.workspace_low, -c.workspace_high);
  EXPECT_EQ(device->name(), "forcedimension");
}

TEST_F(ForceDimension, OpensBySerialNumberAndByModelOfEitherHand) {
  add(kOmega3, 11);
  add(kSigma7Left, 22);
  add(kSigma7, 33);
  EXPECT_EQ(open_force_dimension(options_for("33"))->capabilities().serial_number, "33");
  EXPECT_EQ(open_force_dimension(options_for("sigma.7-left"))->capabilities().serial_number, "22");
  EXPECT_EQ(open_force_dimension(options_for("sigma.7-right"))->capabilities().serial_number, "33");
  const auto first = open_force_dimension(options_for("sigma.7")),
             second = open_force_dimension(options_for("sigma.7"));
  EXPECT_NE(first->capabilities().serial_number, second->capabilities().serial_number);
  EXPECT_EQ(open_force_dimension(options_for("omega.3"))->capabilities().serial_number, "11");
  EXPECT_NE(refusal(options_for("omega.3-left")), "") << "there is no such model";
}

TEST_F(ForceDimension, TellsLeftHandedDevicesApart) {
  add(kSigma7Left);
  const DeviceCapabilities c = open_force_dimension(options_for())->capabilities();
  EXPECT_EQ(c.model, "sigma.7 (stand-in), left-handed");
  EXPECT_EQ(c.output_degrees_of_freedom, 6);
  EXPECT_EQ(c.peak_torque, 0.2);
  EXPECT_EQ(c.rotational_stiffness, 1);
}

TEST_F(ForceDimension, ReportsWhyNoDeviceCouldBeOpened) {
  const std::string nothing = refusal(options_for());
  EXPECT_NE(nothing.find("no device found (stand-in) (error 5), 0 connected, 0 of them free"), std::string::npos)
      << nothing;
  EXPECT_NE(nothing.find("udev"), std::string::npos) << nothing;
  add(kOmega3);
  dhdsim_set_in_use(0, 1);
  const std::string in_use = refusal(options_for("1234"));
  EXPECT_NE(in_use.find("\"1234\": device in use (stand-in) (error 20), 1 connected, 0 of them free"),
            std::string::npos)
      << in_use;
  const std::string unknown = refusal(options_for("touch"));
  EXPECT_NE(unknown.find("\"touch\""), std::string::npos) << unknown;
  EXPECT_NE(unknown.find("omega.6-left"), std::string::npos) << unknown;
  dhdsim_set_in_use(0, 0);
  dhdsim_fail(0, DHDSIM_OPEN, kErrorCom, 1);
  EXPECT_NE(refusal(options_for()).find("communication error (stand-in) (error 2)"), std::string::npos);
}

TEST_F(ForceDimension, RefusesADeviceThatIsOpenInThisProgram) {
  add(kOmega3);
  const auto device = open_force_dimension(options_for());
  EXPECT_NE(refusal(options_for()).find("device in use"), std::string::npos);
  dhdsim_share(0, 1);  // as if the library did not refuse it
  EXPECT_NE(refusal(options_for()).find("open in this program already"), std::string::npos);
  EXPECT_EQ(dhdsim_get_counters(0).closes, 0);
}

TEST_F(ForceDimension, RefusesOptionsOutOfRange) {
  add(kOmega3);
  ForceDimensionOptions options = options_for();
  for (const double watchdog : {0.0, 1e-3, 32e-3, -1.0}) {
    options.watchdog = watchdog;
    EXPECT_NE(refusal(options).find("watchdog"), std::string::npos) << watchdog;
  }
  const auto device = open_force_dimension(options_for());
  RunOptions slow = quick();
  slow.guard.period = 11e-3;
  EXPECT_THROW(run(*device, push_for(5), slow), Error) << "two ticks are longer than the watchdog waits";
  EXPECT_EQ(dhdsim_get_counters(0).enables, 0);
  options = options_for();
  options.effector_mass = -0.1;
  EXPECT_NE(refusal(options).find("effector_mass"), std::string::npos);
}

TEST_F(ForceDimension, IsFoundByTheNameOfItsModel) {
  add(kOmega3);
  use_force_dimension();
  EXPECT_EQ(open_device("forcedimension:omega.3")->name(), "forcedimension:omega.3");
}

TEST_F(ForceDimension, LimitsTheForceOfAnUnknownDevice) {
  add(kCustom);
  const auto device = open_force_dimension(options_for());
  EXPECT_EQ(device->capabilities().peak_force, 1);
  EXPECT_EQ(device->capabilities().output_degrees_of_freedom, 3);
  EXPECT_LE(device->capabilities().stiffness, 500);
  const RunReport report = run(*device, push_for(300, {Vec3(9, 0, 0), Vec3::Zero()}));
  EXPECT_TRUE(says(report.warnings, "(type 91) is unknown"));
  EXPECT_NEAR(rendered_wrench(0, 299).force.norm(), 1, 1e-12);
  EXPECT_EQ(dhdsim_get_counters(0).max_force, 1);
}

TEST_F(ForceDimension, ConvertsTheFrameOfTheLibraryToTheBase) {
  add(kSigma7);
  const Mat3 about_up = rotation_from_vector(Vec3(0, 0, 0.3));  // z is up for the library
  const std::array<double, 3> position = {0.01, 0.02, 0.03};    // towards the user, right, up
  const std::array<double, 9> rows = {about_up(0, 0), about_up(0, 1), about_up(0, 2), about_up(1, 0), about_up(1, 1),
                                      about_up(1, 2), about_up(2, 0), about_up(2, 1), about_up(2, 2)};
  const std::array<double, 3> linear = {0.1, 0.2, 0.3}, angular = {1, 2, 3};
  dhdsim_set_pose(0, position.data(), rows.data());
  dhdsim_set_velocity(0, linear.data(), angular.data());
  const auto device = open_force_dimension(options_for());
  run(*device, [&](const DeviceState& state) {
    EXPECT_EQ(state.X_BS.translation, Vec3(0.02, 0.03, 0.01));  // right, up, towards the user
    EXPECT_LT((state.X_BS.rotation - rotation_from_vector(Vec3(0, 0.3, 0))).norm(), 1e-12);
    EXPECT_EQ(state.velocity.linear, Vec3(0.2, 0.3, 0.1));
    EXPECT_EQ(state.velocity.angular, Vec3(2, 3, 1));
    return DeviceCommand{{}, true};
  });
}

TEST_F(ForceDimension, SendsForceAndTorqueInTheFrameOfTheLibrary) {
  add(kSigma7);
  const auto device = open_force_dimension(options_for());
  const Wrench wrench{Vec3(0.5, -0.25, 0.125), Vec3(0.010, 0.005, -0.020)};
  run(*device, push_for(300, wrench));
  std::array<double, 3> f{}, t{};
  dhdsim_get_committed(0, 300, f.data(), t.data());  // the first two commands are sent at the start
  EXPECT_EQ(f, in_library(wrench.force));
  EXPECT_EQ(t, in_library(wrench.torque));
  EXPECT_EQ(dhdsim_get_counters(0).max_torque, 0.2);
}

TEST_F(ForceDimension, GivesNoTorqueToAnyPassiveWrist) {
  for (const int type : {kOmega3, kOmega7}) {  // omega.6 and Falcon are in the contract
    dhdsim_reset();
    add(type);
    const auto device = open_force_dimension(options_for());
    run(*device, push_for(200, {Vec3(1, 0, 0), Vec3(0, 0, 0.1)}));
    EXPECT_EQ(dhdsim_get_counters(0).torques_on_passive_wrist, 0) << type;
    EXPECT_TRUE(has_any(device->output().changes, OutputChange::no_actuator)) << type;
  }
}

TEST_F(ForceDimension, UsesTheReportedAngularVelocityOrEstimatesIt) {
  for (const bool reports : {true, false}) {
    dhdsim_reset();
    dhdsim_device spec = dhdsim_device_of(kOmega6, 1);
    spec.reports_angular_velocity = reports ? 1 : 0;
    dhdsim_add_device(&spec);
    const auto device = open_force_dimension(options_for());
    Vec3 seen = Vec3::Zero();
    run(
        *device,
        [&, n = 0](const DeviceState& state) mutable {
          seen = state.velocity.angular;
          return DeviceCommand{{}, ++n >= 200};
        },
        quick(),
        [](long tick) {
          const Pose X{rotation_from_vector(Vec3(0, 0, 2e-3 * double(tick))), Vec3(1e-5 * double(tick), 0, 0)};
          place_omega(0, X, {Vec3(0.01, 0, 0), Vec3(0, 0, 7)});  // a wrong value, so that the test can tell both apart
        });
    EXPECT_LT((seen - Vec3(0, 0, reports ? 7 : 2)).norm(), 0.01) << reports;
  }
}

TEST_F(ForceDimension, TreatsPositiveReturnValuesAsSuccess) {
  for (const int positive : {1, 2}) {  // time guard, motors saturated
    dhdsim_reset();
    add(kOmega6);
    const auto device = open_force_dimension(options_for());
    dhdsim_return_on_success(0, positive);
    const RunReport report = run(*device, push_for(300));
    EXPECT_EQ(report.fault, DeviceFault::none) << positive;
    EXPECT_EQ(report.arming, ArmingState::on) << positive;
    EXPECT_EQ(report.ticks, 300U) << positive;
    EXPECT_NEAR(rendered_wrench(0, 300).force.x(), 1, 1e-12) << positive;
    EXPECT_EQ(says(report.warnings, "could not render all"), positive == 2);
  }
}

TEST_F(ForceDimension, SendsACommandInEveryTickSoThatGravityIsCompensated) {
  add(kOmega6);
  ForceDimensionOptions options = options_for();
  options.effector_mass = 0.05;
  const auto device = open_force_dimension(options);
  double carried = 0;
  const RunReport report = run(
      *device,
      [n = 0](const DeviceState&) mutable {
        return DeviceCommand{{}, ++n >= 500};
      },
      quick(),
      [&](long tick) {
        std::array<double, 3> motors{};
        dhdsim_get_motor_force(0, motors.data());
        if (tick == 400) carried = motors[2];
      });
  const dhdsim_counters c = dhdsim_get_counters(0);
  EXPECT_GE(c.commands, 501) << "one per tick, of zero force";
  EXPECT_EQ(c.unsupported, 0);
  EXPECT_GT(carried, 1) << "the weight of the arm, upwards";
  EXPECT_EQ(c.gravity_on, 1);
  EXPECT_EQ(c.effector_mass, 0.05);
  EXPECT_TRUE(report.warnings.empty()) << report.warnings.front();
}

TEST_F(ForceDimension, SetsTheWatchdogInUnitsOf125usAndOnlyInExpertMode) {
  add(kOmega3);
  for (const auto& [seconds, steps] : {std::pair(20e-3, 160), std::pair(31.875e-3, 255), std::pair(2e-3, 16)}) {
    ForceDimensionOptions options = options_for();
    options.watchdog = seconds;
    const auto device = open_force_dimension(options);
    run(*device, push_for(5));
    EXPECT_EQ(dhdsim_get_counters(0).watchdog, steps);
  }
  EXPECT_EQ(dhdsim_get_counters(0).expert_mode_violations, 0);
  EXPECT_EQ(dhdsim_get_counters(0).expert_mode, 0);
}

TEST_F(ForceDimension, LeavesNoForceAndEngagesTheBrakesWhenItsLoopCannotBegin) {
  add(kOmega6);
  auto device = open_force_dimension(options_for());
  RunOptions impossible = quick();
  impossible.guard.period = 1e-6;  // an error that is found only after the device was started
  EXPECT_THROW(run(*device, push_for(1000), impossible), Error);
  expect_safe(0);
  device.reset();
  EXPECT_EQ(dhdsim_get_counters(0).off_before_close, 1);
  EXPECT_EQ(dhdsim_get_counters(0).closes, 1);
}

TEST_F(ForceDimension, RunsTwoDevicesAtOnce) {
  add(kOmega6, 1);
  add(kOmega3, 2);
  const auto left = open_force_dimension(options_for("1"));
  ForceDimensionOptions meanwhile = options_for("2");
  meanwhile.clock = [now = 0.0]() mutable { return now += 1e-3; };  // the watchdog of the first sees no time pass
  const auto right = open_force_dimension(meanwhile);
  RunReport other;
  const RunReport report = run(*left, [&, n = 0](const DeviceState&) mutable {
    if (++n == 100) {
      RunOptions options = quick();
      options.simulated_time = true;
      other = right->run(push_for(200, {Vec3(0, 2, 0), Vec3::Zero()}), options);
    }
    return DeviceCommand{{}, n >= 200};
  });
  EXPECT_EQ(report.ticks, 200U);
  EXPECT_EQ(other.ticks, 200U);
  EXPECT_NEAR(rendered_wrench(1, 200).force.y(), 2, 1e-12);
  for (const int device : {0, 1}) expect_safe(device);
}

}  // namespace
}  // namespace hapticut::force_dimension_test
