// SPDX-License-Identifier: Apache-2.0
// The stand-in of Force Dimension's library behaves as is known of the real one; else the adapter's tests mean nothing.
#include <dhdc.h>
#include <dhdsim.h>
#include <dlfcn.h>
#include <drdc.h>
#include <gtest/gtest.h>

#include <array>
#include <string>
#include <thread>

#include "device/force_dimension/faults.hpp"
#include "device/force_dimension/models.hpp"

namespace hapticut::force_dimension_stand_in_test {
namespace {

namespace fd = hapticut::force_dimension;

static_assert(fd::error::kCommunication == DHD_ERROR_COM && fd::error::kBusy == DHD_ERROR_DHC_BUSY &&
              fd::error::kNoDriver == DHD_ERROR_NO_DRIVER_FOUND && fd::error::kNoDevice == DHD_ERROR_NO_DEVICE_FOUND &&
              fd::error::kTimeout == DHD_ERROR_TIMEOUT && fd::error::kGeometry == DHD_ERROR_GEOMETRY &&
              fd::error::kNotReady == DHD_ERROR_DEVICE_NOT_READY && fd::error::kNotEnabled == DHD_ERROR_NOT_ENABLED);
static_assert(int(fd::ForceOff::usb) == DHD_FORCE_OFF_USBDISCN && int(fd::ForceOff::deadman) == DHD_FORCE_OFF_DEADMAN);

class DhdStandIn : public testing::Test {
 protected:
  void SetUp() override {
    dhdsim_reset();
    const dhdsim_device omega = dhdsim_device_of(DHD_DEVICE_OMEGA6_RIGHT, 7);
    dhdsim_add_device(&omega);
    dhdOpen();
    dhdEnableExpertMode();
    dhdEnableForce(DHD_ON);
    dhdDisableExpertMode();
  }
  void TearDown() override { dhdsim_reset(); }

  static int status(int index) {
    std::array<int, DHD_MAX_STATUS> entries{};
    EXPECT_EQ(dhdGetStatus(entries.data()), 0);
    return entries[std::size_t(index)];
  }
  static std::array<double, 3> motors() {
    std::array<double, 3> force{};
    dhdsim_get_motor_force(0, force.data());
    return force;
  }
};

TEST_F(DhdStandIn, ExportsTheFunctionsThatTheAdapterMayUse) {
  for (const char* name : {"dhdGetDeviceCount",
                           "dhdGetAvailableCount",
                           "dhdOpen",
                           "dhdOpenID",
                           "dhdOpenType",
                           "dhdOpenSerial",
                           "dhdClose",
                           "dhdStop",
                           "dhdGetSystemType",
                           "dhdGetSystemName",
                           "dhdGetSerialNumber",
                           "dhdGetSDKVersion",
                           "dhdEnableForce",
                           "dhdGetStatus",
                           "dhdHasWrist",
                           "dhdHasActiveWrist",
                           "dhdHasGripper",
                           "dhdHasActiveGripper",
                           "dhdIsLeftHanded",
                           "dhdGetPosition",
                           "dhdGetPositionAndOrientationFrame",
                           "dhdGetOrientationFrame",
                           "dhdGetLinearVelocity",
                           "dhdGetAngularVelocityRad",
                           "dhdConfigLinearVelocity",
                           "dhdSetForce",
                           "dhdSetForceAndTorque",
                           "dhdSetForceAndTorqueAndGripperForce",
                           "dhdGetForceAndTorqueAndGripperForce",
                           "dhdGetButtonMask",
                           "dhdGetButton",
                           "dhdGetComFreq",
                           "dhdSetGravityCompensation",
                           "dhdSetEffectorMass",
                           "dhdSetBrakes",
                           "dhdSetMaxForce",
                           "dhdSetMaxTorque",
                           "dhdGetMaxForce",
                           "dhdGetMaxTorque",
                           "dhdErrorGetLast",
                           "dhdErrorGetLastStr",
                           "dhdGetTime",
                           "dhdSleep",
                           "dhdEnableSimulator",
                           "dhdEnableExpertMode",
                           "dhdDisableExpertMode",
                           "dhdSetTimeGuard",
                           "dhdSetVelocityThreshold",
                           "dhdSetWatchdog",
                           "drdOpenID",
                           "drdClose",
                           "drdIsInitialized",
                           "drdAutoInit",
                           "drdStop"})
    EXPECT_NE(dlsym(RTLD_DEFAULT, name), nullptr) << name;
}

TEST_F(DhdStandIn, IsKnownByTheNumbersOfItsModels) {
  for (const auto& [name, type] :
       {std::pair("omega.3", DHD_DEVICE_OMEGA3), std::pair("omega.6", DHD_DEVICE_OMEGA6_RIGHT),
        std::pair("omega.6-left", DHD_DEVICE_OMEGA6_LEFT), std::pair("omega.7", DHD_DEVICE_OMEGA7_RIGHT),
        std::pair("omega.7-left", DHD_DEVICE_OMEGA7_LEFT), std::pair("falcon", DHD_DEVICE_FALCON),
        std::pair("delta.3", DHD_DEVICE_DELTA3), std::pair("sigma.3", DHD_DEVICE_SIGMA3),
        std::pair("sigma.7", DHD_DEVICE_SIGMA7_RIGHT), std::pair("sigma.7-left", DHD_DEVICE_SIGMA7_LEFT),
        std::pair("lambda.3", DHD_DEVICE_LAMBDA3), std::pair("lambda.6", DHD_DEVICE_LAMBDA6_RIGHT),
        std::pair("lambda.6-left", DHD_DEVICE_LAMBDA6_LEFT), std::pair("lambda.7", DHD_DEVICE_LAMBDA7_RIGHT),
        std::pair("lambda.7-left", DHD_DEVICE_LAMBDA7_LEFT)}) {
    const fd::Model* model = fd::find_model(type);
    ASSERT_NE(model, nullptr) << name;
    EXPECT_EQ(model->name, name);
  }
  EXPECT_EQ(fd::models().size(), 15U);
  for (const int other : {DHD_DEVICE_NONE, DHD_DEVICE_CONTROLLER, DHD_DEVICE_CONTROLLER_HR, DHD_DEVICE_CUSTOM})
    EXPECT_EQ(fd::find_model(other), nullptr) << other;
}

TEST_F(DhdStandIn, GivesEachThreadItsOwnLastError) {
  EXPECT_LT(dhdOpenSerial(99), 0);
  EXPECT_EQ(dhdErrorGetLast(), DHD_ERROR_NO_DEVICE_FOUND);
  std::thread([] { EXPECT_EQ(dhdErrorGetLast(), DHD_NO_ERROR); }).join();
  EXPECT_LT(dhdOpenSerial(7), 0);
  EXPECT_EQ(dhdErrorGetLast(), DHD_ERROR_DEVICE_IN_USE);
}

TEST_F(DhdStandIn, WantsExpertModeForWatchdogAndForces) {
  EXPECT_LT(dhdSetWatchdog(80), 0);
  EXPECT_EQ(dhdErrorGetLast(), DHD_ERROR_EXPERT_MODE_DISABLED);
  EXPECT_LT(dhdEnableForce(DHD_OFF), 0);
  EXPECT_EQ(dhdsim_get_counters(0).expert_mode_violations, 2);
  dhdEnableExpertMode();
  EXPECT_EQ(dhdSetWatchdog(80), 0);
}

TEST_F(DhdStandIn, TripsItsWatchdogBySimulatedTime) {
  dhdEnableExpertMode();
  dhdSetWatchdog(80);  // 10 ms
  dhdSetForce(1, 0, 0);
  dhdsim_advance(9.9e-3);
  EXPECT_EQ(status(DHD_STATUS_FORCE), 1);
  EXPECT_EQ(motors()[0], 1);
  dhdsim_advance(0.2e-3);
  EXPECT_EQ(status(DHD_STATUS_FORCE), 0);
  EXPECT_EQ(status(DHD_STATUS_FORCE_OFF_CAUSE), DHD_FORCE_OFF_WATCHDOG);
  EXPECT_EQ(motors()[0], 0);
  dhdSetForce(1, 0, 0);
  EXPECT_EQ(motors()[0], 0) << "a command does not bring the forces back";
  dhdEnableForce(DHD_ON);
  dhdSetForce(1, 0, 0);
  EXPECT_EQ(motors()[0], 1);
  for (int n = 0; n < 100; ++n, dhdsim_advance(9e-3)) dhdSetForce(1, 0, 0);
  EXPECT_EQ(status(DHD_STATUS_FORCE), 1);
}

TEST_F(DhdStandIn, CompensatesGravityOnlyWithCommands) {
  dhdSetForce(0, 0, 0);
  EXPECT_EQ(motors()[2], 0) << "not switched on";
  dhdSetGravityCompensation(DHD_ON);
  EXPECT_EQ(motors()[2], 0) << "no command since then";
  dhdSetForce(0, 0, 0);
  EXPECT_NEAR(motors()[2], 0.2 * 9.81, 1e-9);
  const double before = dhdsim_get_counters(0).unsupported;
  for (int n = 0; n < 10; ++n, dhdsim_advance(1e-3)) dhdSetForce(0, 0, 0);
  EXPECT_EQ(dhdsim_get_counters(0).unsupported, before);
  dhdsim_advance(5e-3);
  EXPECT_GT(dhdsim_get_counters(0).unsupported, before) << "the loop stopped, and the arm sinks";
}

TEST_F(DhdStandIn, BrakesWhenItIsMovedTooFast) {
  const std::array<double, 3> fast = {0, 1.1, 0}, still = {};
  dhdSetForce(1, 0, 0);
  dhdsim_set_velocity(0, fast.data(), still.data());
  dhdsim_advance(1e-3);
  EXPECT_EQ(status(DHD_STATUS_BRAKE), 1);
  EXPECT_EQ(status(DHD_STATUS_FORCE), 0);
  EXPECT_EQ(status(DHD_STATUS_FORCE_OFF_CAUSE), DHD_FORCE_OFF_VELOCITY);
}

TEST_F(DhdStandIn, NamesEveryCauseAndLetsOnlyTheRightOnesBeOvercome) {
  dhdEnableExpertMode();
  for (const dhdsim_cause cause : {DHDSIM_OFF_BUTTON, DHDSIM_OFF_VELOCITY, DHDSIM_OFF_WATCHDOG, DHDSIM_OFF_SOFTWARE,
                                   DHDSIM_OFF_USBDISCN, DHDSIM_OFF_DEADMAN}) {
    dhdsim_switch_off(0, cause);
    EXPECT_EQ(status(DHD_STATUS_FORCE_OFF_CAUSE), int(cause));
    const bool held = cause == DHDSIM_OFF_BUTTON || cause == DHDSIM_OFF_SOFTWARE || cause == DHDSIM_OFF_DEADMAN;
    EXPECT_EQ(dhdEnableForce(DHD_ON) < 0, held) << cause;
    dhdsim_switch_on(0);
    EXPECT_EQ(status(DHD_STATUS_FORCE_OFF_CAUSE), DHD_FORCE_OFF_NONE);
  }
}

TEST_F(DhdStandIn, AnswersWithPositiveNumbersThatAreNoErrors) {
  std::array<double, 3> p{};
  for (const int positive : {0, DHD_TIMEGUARD, DHD_MOTOR_SATURATED}) {
    dhdsim_return_on_success(0, positive);
    EXPECT_EQ(dhdGetPosition(&p[0], &p[1], &p[2]), positive);
    EXPECT_EQ(dhdSetForce(0, 0, 0), positive);
  }
  dhdsim_unplug(0);
  EXPECT_LT(dhdSetForce(0, 0, 0), 0);
  EXPECT_EQ(dhdErrorGetLast(), DHD_ERROR_COM);
}

}  // namespace
}  // namespace hapticut::force_dimension_stand_in_test
