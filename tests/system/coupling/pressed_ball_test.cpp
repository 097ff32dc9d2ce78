// SPDX-License-Identifier: Apache-2.0
#include "hapticut/analysis/pressed_ball.hpp"

#include <gtest/gtest.h>

#include "hapticut/analysis/faults.hpp"
#include "hapticut/loop/coupling_gains.hpp"

namespace hapticut {
void PrintTo(const DeviceModel& model, std::ostream* out) { *out << model.name; }
}  // namespace hapticut

namespace hapticut::pressed_ball_test {
namespace {

constexpr double kHard = 1e16;  // [N/m^4] at which a ball of 1 mm under 5 N sinks in by 0.09 mm

ClosedLoopConfig pressed(const DeviceModel& device, int delay) {
  ClosedLoopConfig config;
  config.device = device;
  config.hand = hand_model("nominal");
  config.delay = delay;
  config.velocity_filter = 100;
  return config;
}

PressedBall coupled(const DeviceModel& device) {
  PressedBall ball;
  ball.coupling = coupling_gains(capabilities(device));
  ball.coupling->angular_stiffness = 0;
  return ball;
}

class EveryDevice : public testing::TestWithParam<DeviceModel> {};

TEST_P(EveryDevice, RendersMaterialTenTimesAsStiffThroughTheCoupling) {
  const PressedBall direct, through = coupled(GetParam());
  for (const int delay : {0, 2}) {
    const ClosedLoopConfig config = pressed(GetParam(), delay);
    StabilitySearch search = pressed_search(direct);
    search.tolerance = 0.2;
    const double k_direct = max_stable_stiffness(config, contact_models(direct), search);
    EXPECT_GT(k_direct, 1e11) << "the search must find a stable stiffness, else the test proves nothing";
    EXPECT_LT(k_direct, 1e15);
    for (const double factor : {10.0, 100.0, 1000.0})
      EXPECT_TRUE(is_stable(config, contact_models(through), factor * k_direct, search)) << delay << ", " << factor;
  }
}

// Deep in soft material two runs come to rest 0.2 um apart, because the material holds the tool where it is. This is no
// instability.
TEST_P(EveryDevice, IsStableInSoftMaterial) {
  const PressedBall through = coupled(GetParam());
  for (const int delay : {0, 1, 2})
    for (double k_v = 7e11; k_v < 2e12; k_v *= 1.1)
      EXPECT_TRUE(is_stable(pressed(GetParam(), delay), contact_models(through), k_v, pressed_search(through)))
          << k_v << " N/m^4, delay " << delay;
}

TEST_P(EveryDevice, NeitherThrowsTheHandBackNorBuzzesThroughTheCoupling) {
  const PressedBall through = coupled(GetParam());
  for (const int delay : {0, 2}) {
    const ClosedLoopConfig config = pressed(GetParam(), delay);
    BounceTest test;
    test.height = through.radius;
    test.phases = 5;
    const Bounce bounced = measure_bounce(config, contact_models(through), kHard, test);
    EXPECT_LT(bounced.restitution, 1);
    EXPECT_LT(bounced.generated_energy, 0);
    PressTest press_test;
    press_test.height = through.radius;
    press_test.depth = 5e-3;
    press_test.seconds = 1.5;
    press_test.measured = 0.5;
    const Buzz buzz = measure_buzz(config, contact_models(through), kHard, press_test);
    EXPECT_FALSE(buzz.buzzes());
    EXPECT_LT(buzz.position_rms, 1e-9);
    EXPECT_GT(buzz.max_force, 0.5);
  }
}

TEST_P(EveryDevice, ObeysTheRulesOfFaultsWithTheRealModel) {
  const PressedBall through = coupled(GetParam());
  GuardOptions options;
  options.stiffness = through.coupling->stiffness;
  const SafetyGuard guard(capabilities(GetParam()), options);
  for (const int delay : {0, 2})
    for (const InjectedFault fault : injected_faults()) {
      ClosedLoopConfig config = pressed(GetParam(), delay);
      config.dry_friction = config.encoder = config.saturation = true;
      const FaultResponse response =
          measure_fault_response(config, contact_models(through), kHard, options, fault, through.radius);
      EXPECT_TRUE(obeys_the_rules(response, guard, config.period)) << name_of(fault) << ", delay " << delay;
    }
}

INSTANTIATE_TEST_SUITE_P(Devices, EveryDevice, testing::ValuesIn(device_models().begin(), device_models().end()),
                         [](const auto& device) { return std::string(device.param.name); });

}  // namespace
}  // namespace hapticut::pressed_ball_test
