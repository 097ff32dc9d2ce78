// SPDX-License-Identifier: Apache-2.0
// The stand-in of the OpenHaptics library behaves as the manual says of the real one; else the adapter's tests mean
// nothing.
#include <HD/hd.h>
#include <dlfcn.h>
#include <gtest/gtest.h>
#include <hdsim.h>

#include <array>
#include <functional>
#include <vector>

namespace hapticut::stand_in_test {
namespace {

class StandIn : public testing::Test {
 protected:
  void SetUp() override {
    hdsim_reset();
    const hdsim_device touch = hdsim_touch("Default Device");
    hdsim_add_device(&touch);
    device = hdInitDevice(HD_DEFAULT_DEVICE);
  }
  void TearDown() override { hdsim_reset(); }

  static HDerror next_error() { return hdGetError().errorCode; }
  void frame(const std::array<double, 3>& force) const {
    hdBeginFrame(device);
    hdSetDoublev(HD_CURRENT_FORCE, force.data());
    hdEndFrame(device);
  }
  HHD device = HD_INVALID_HANDLE;
};

TEST_F(StandIn, ExportsAllFunctionsOfTheLibrary) {
  const std::vector<const char*> names = {"hdInitDevice",
                                          "hdMakeCurrentDevice",
                                          "hdDisableDevice",
                                          "hdGetCurrentDevice",
                                          "hdBeginFrame",
                                          "hdEndFrame",
                                          "hdGetError",
                                          "hdGetErrorString",
                                          "hdEnable",
                                          "hdDisable",
                                          "hdIsEnabled",
                                          "hdGetBooleanv",
                                          "hdGetIntegerv",
                                          "hdGetFloatv",
                                          "hdGetDoublev",
                                          "hdGetLongv",
                                          "hdGetString",
                                          "hdSetBooleanv",
                                          "hdSetIntegerv",
                                          "hdSetFloatv",
                                          "hdSetDoublev",
                                          "hdSetLongv",
                                          "hdCheckCalibration",
                                          "hdCheckCalibrationStyle",
                                          "hdUpdateCalibration",
                                          "hdScaleGimbalAngles",
                                          "hdDeploymentLicense",
                                          "hdUpdateCalibrationMessage",
                                          "hdStartScheduler",
                                          "hdStopScheduler",
                                          "hdSetSchedulerRate",
                                          "hdScheduleSynchronous",
                                          "hdUnschedule",
                                          "hdScheduleAsynchronous",
                                          "hdWaitForCompletion",
                                          "hdGetSchedulerTimeStamp"};
  ASSERT_EQ(names.size(), 36U);
  for (const char* name : names) EXPECT_NE(dlsym(RTLD_DEFAULT, name), nullptr) << name;
}

TEST_F(StandIn, KeepsOneStackOfErrors) {
  EXPECT_EQ(next_error(), HDerror(HD_SUCCESS));
  hdEndFrame(device);
  (void)hdInitDevice("nobody");
  EXPECT_EQ(next_error(), HDerror(HD_DEVICE_FAULT)) << "last in, first out";
  EXPECT_EQ(next_error(), HDerror(HD_ILLEGAL_END));
  EXPECT_EQ(next_error(), HDerror(HD_SUCCESS));
  EXPECT_EQ(hdInitDevice("Default Device"), HHD(HD_INVALID_HANDLE));
  EXPECT_EQ(next_error(), HDerror(HD_DEVICE_ALREADY_INITIATED));
}

TEST_F(StandIn, WantsFramesAndZeroesTheForceInEach) {
  const std::array<double, 3> force = {0.5, 0, 0};
  hdSetDoublev(HD_CURRENT_FORCE, force.data());
  EXPECT_EQ(next_error(), HDerror(HD_FRAME_ERROR));
  hdEnable(HD_FORCE_OUTPUT);
  hdStartScheduler();
  (void)hdsim_run_ticks(1);
  frame(force);
  EXPECT_EQ(next_error(), HDerror(HD_SUCCESS));
  std::array<double, 3> seen{};
  hdGetDoublev(HD_CURRENT_FORCE, seen.data());
  EXPECT_EQ(seen, force) << "outside of a frame: that of the last one";
  frame(force);
  EXPECT_EQ(next_error(), HDerror(HD_ILLEGAL_BEGIN)) << "one frame in a tick";
  (void)hdsim_run_ticks(1);
  hdBeginFrame(device);
  hdBeginFrame(device);  // frames may nest
  hdEndFrame(device);
  hdEndFrame(device);
  EXPECT_EQ(next_error(), HDerror(HD_SUCCESS));
  hdsim_get_committed_force(0, seen.data(), nullptr);
  EXPECT_EQ(seen[0], 0) << "a frame that sets no force commands none";
}

/// Counts its calls and notes its place among others.
struct Noted {
  std::vector<int>* order;
  int number, lives;
  static HDCallbackCode HDCALLBACK call(void* data) {
    auto* self = static_cast<Noted*>(data);
    self->order->push_back(self->number);
    return --self->lives > 0 ? HD_CALLBACK_CONTINUE : HD_CALLBACK_DONE;
  }
};

TEST_F(StandIn, SchedulesByPriorityAndDropsWhatIsDone) {
  std::vector<int> order;
  Noted low{&order, 1, 3}, high{&order, 2, 2}, at_once{&order, 3, 2};
  hdScheduleSynchronous(Noted::call, &at_once, HD_DEFAULT_SCHEDULER_PRIORITY);
  EXPECT_EQ(order, (std::vector<int>{3, 3})) << "in the caller, where the scheduler does not run";
  const HDSchedulerHandle a = hdScheduleAsynchronous(Noted::call, &low, HD_MIN_SCHEDULER_PRIORITY);
  const HDSchedulerHandle b = hdScheduleAsynchronous(Noted::call, &high, HD_MAX_SCHEDULER_PRIORITY);
  hdStartScheduler();
  order.clear();
  (void)hdsim_run_ticks(4);
  EXPECT_EQ(order, (std::vector<int>{2, 1, 2, 1, 1}));
  EXPECT_EQ(hdWaitForCompletion(a, HD_WAIT_CHECK_STATUS), HD_FALSE);
  hdUnschedule(b);
  EXPECT_EQ(next_error(), HDerror(HD_INVALID_OPERATION)) << "it is over";
}

TEST_F(StandIn, KnowsTypesUnitsAndRates) {
  HDint integer = 0;
  HDdouble real = 0;
  hdGetIntegerv(HD_OUTPUT_DOF, &integer);
  EXPECT_EQ(integer, 3);
  hdGetIntegerv(HD_NOMINAL_MAX_FORCE, &integer);
  EXPECT_EQ(next_error(), HDerror(HD_INVALID_INPUT_TYPE));
  hdGetDoublev(HD_NOMINAL_MAX_STIFFNESS, &real);
  EXPECT_EQ(real, 0.5) << "N/mm";
  hdGetDoublev(0x9999, &real);
  EXPECT_EQ(next_error(), HDerror(HD_INVALID_ENUM));
  for (const HDulong rate : {500UL, 1000UL, 1600UL, 2000UL, 1143UL}) hdSetSchedulerRate(rate);
  EXPECT_EQ(next_error(), HDerror(HD_SUCCESS));
  hdSetSchedulerRate(999);
  EXPECT_EQ(next_error(), HDerror(HD_INVALID_VALUE));
}

TEST_F(StandIn, RampsForcesAndTogglesItsAmplifiers) {
  struct Push {
    HHD device;
    std::array<double, 3> force;
    static HDCallbackCode HDCALLBACK call(void* data) {
      auto* self = static_cast<Push*>(data);
      hdBeginFrame(self->device);
      hdSetDoublev(HD_CURRENT_FORCE, self->force.data());
      hdEndFrame(self->device);
      return HD_CALLBACK_CONTINUE;
    }
  } push{device, {1, 0, 0}};
  const auto rendered = [] {
    std::array<double, 3> force{};
    hdsim_get_rendered_force(0, force.data());
    return force[0];
  };
  hdEnable(HD_FORCE_OUTPUT);
  (void)hdScheduleAsynchronous(Push::call, &push, HD_MAX_SCHEDULER_PRIORITY);
  hdStartScheduler();
  (void)hdsim_run_ticks(51);
  EXPECT_NEAR(rendered(), 0.5, 1e-9) << "10 N/s from the start on";
  (void)hdsim_run_ticks(100);
  EXPECT_EQ(rendered(), 1);

  push.force = {50, 0, 0};  // clamped to 3.3 N, a step of 2.3 N: no limit of the driver
  (void)hdsim_run_ticks(500);
  EXPECT_EQ(next_error(), HDerror(HD_SUCCESS));
  EXPECT_NEAR(rendered(), 3.3, 1e-9);

  push.force = {-3.3, 0, 0};  // a step of 6.6 N; 4 N a tick are allowed
  (void)hdsim_run_ticks(1);
  EXPECT_EQ(next_error(), HDerror(HD_EXCEEDED_MAX_FORCE_IMPULSE));
  EXPECT_EQ(rendered(), 0);
  (void)hdsim_run_ticks(100);
  EXPECT_NEAR(rendered(), -1, 0.02) << "and back on the ramp";

  const std::array<double, 3> fast = {0, 1300, 0};  // mm/s
  hdsim_set_velocity(0, fast.data());
  (void)hdsim_run_ticks(1);
  EXPECT_EQ(next_error(), HDerror(HD_EXCEEDED_MAX_VELOCITY));

  const std::array<double, 3> still = {};
  hdsim_set_velocity(0, still.data());
  hdDisable(HD_MAX_FORCE_CLAMPING);
  push.force = {-5, 0, 0};
  (void)hdsim_run_ticks(1);
  EXPECT_EQ(next_error(), HDerror(HD_EXCEEDED_MAX_FORCE));
}

}  // namespace
}  // namespace hapticut::stand_in_test
