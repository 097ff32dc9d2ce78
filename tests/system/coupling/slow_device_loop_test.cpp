// SPDX-License-Identifier: Apache-2.0
// A device that is slower than its loop: the model makes a step for each new reading, so the hand stands still.
#include <gtest/gtest.h>

#include <algorithm>

#include "hapticut/device/simulated/mock.hpp"
#include "hapticut/hapticut.hpp"
#include "hapticut/loop/simulation_model.hpp"

namespace hapticut::slow_device_loop_test {
namespace {

using namespace units;

constexpr double kRadius = 1.5 * mm;
constexpr double kTouch = 2.5, kAtRest = 3.5, kEnd = 4;  // [s]; the force fades out at the end

/// A mock whose driver has a new reading only in every n-th tick.
class SlowDevice : public MockDevice {
 public:
  SlowDevice(const MockOptions& options, int ticks_per_reading)
      : MockDevice(options), ticks_per_reading_(ticks_per_reading) {}
  int ticks = 0, readings = 0;
  double low = 1e9, high = -1e9;  // [N] rendered along z while the hand holds still
  double work = 0;                // [J] done on the hand

 protected:
  bool read(DeviceState& state) noexcept override {
    DeviceState now;
    const bool more = MockDevice::read(now);
    if (ticks++ % ticks_per_reading_ == 0) latest_ = now, ++readings;
    state = latest_;
    return more;
  }
  Wrench write(const Wrench& wrench) noexcept override {
    const Vec3 before = plant().pose().translation;
    const Wrench rendered = MockDevice::write(wrench);
    work += rendered.force.dot(plant().pose().translation - before);
    if (latest_.time > kAtRest && latest_.time < kEnd - 0.1)
      low = std::min(low, wrench.force.z()), high = std::max(high, wrench.force.z());
    return rendered;
  }

 private:
  int ticks_per_reading_;
  DeviceState latest_;
};

/// A light hand that presses a standing ball on enamel with 1.5 N, and holds still.
MockOptions pressing_hand() {
  MockOptions mock;
  mock.device = device_model("omega");
  mock.hand = hand_model("light");
  mock.rigid = false;
  const double pressed = 1.5 / mock.hand.stiffness;
  mock.path = [pressed](double t) {
    const double down = std::clamp((t - kTouch + 0.5) / 0.5, 0.0, 1.0);
    return Pose::from_translation(Vec3(0, 0, 3 * mm - down * (3 * mm + pressed)));
  };
  return mock;
}

TEST(SlowDevice, HoldsAHandStillInAFastLoop) {
  for (const double rate : {1000.0, 4000.0})
    for (const double reading_rate : {500.0, 250.0}) {
      SCOPED_TRACE(std::to_string(rate) + " Hz, read at " + std::to_string(reading_rate) + " Hz");
      SimulationConfig config;
      config.contact_time = ContactTime::end;
      Simulation simulation(build_block({Vec3(-4, -4, -2) * mm, Vec3(4, 4, 0) * mm}, 0.2 * mm, presets::enamel()),
                            Tool(SphereHead{kRadius}, RayHandle{0}, Spindle{}), config);
      SlowDevice device(pressing_hand(), int(rate / reading_rate));
      SimulationModelOptions options;
      options.coupling = coupling_gains(device.capabilities());
      options.map.X_WB.translation.z() = kRadius;
      SimulationModel model(simulation, device, options);
      RealtimeLoopOptions loop_options;
      loop_options.run.seconds = kEnd;
      loop_options.run.simulated_time = true;
      loop_options.run.guard.period = 1 / rate;
      RealtimeLoop loop(device, model, loop_options);
      loop.start();
      const RunReport report = loop.wait();
      EXPECT_EQ(report.arming, ArmingState::on);
      EXPECT_GT(device.low, 0.5);
      EXPECT_LT(device.high - device.low, 0.05);
      EXPECT_LT(device.work, 0.05e-3);
      EXPECT_NEAR(double(loop.latest().tool.steps), double(device.readings), 2);
    }
}

}  // namespace
}  // namespace hapticut::slow_device_loop_test
