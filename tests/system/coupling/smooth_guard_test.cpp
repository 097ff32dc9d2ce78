// SPDX-License-Identifier: Apache-2.0
// A force that the model makes smooth stays smooth behind the guard, on every simulated device and at every rate.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <string>

#include "hapticut/device/simulated/mock.hpp"
#include "hapticut/hapticut.hpp"
#include "hapticut/loop/simulation_model.hpp"

namespace hapticut::smooth_guard_test {
namespace {

using namespace units;

constexpr double kMaxAdded = 0.02;  // [N] per tick
constexpr double kHandle = 60 * mm, kRadius = 1 * mm;
constexpr double kBegin = 2, kTouch = 2.5, kWatched = 4, kEnd = 7.5;  // [s]

/// A stylus that turns to and fro.
struct Wobble {
  double angle;      // [rad]
  double frequency;  // [Hz]
  bool about_tip;    // or about the stylus' own point
};

/// What the guard did to the force of a hand that holds a standing ball on enamel and turns the stylus.
struct Outcome {
  double most_added = 0;  // [N] by which the applied force changed more than the commanded one in the same tick
  double commanded = 0;   // [N] largest change of it per tick
  double applied = 0;     // [N]
  double mean = 0;        // [N] commanded
  double work = 0;        // [J] done on the hand
};

class Watched : public MockDevice {
 public:
  using MockDevice::MockDevice;
  Wrench rendered;

 protected:
  Wrench write(const Wrench& wrench) noexcept override { return rendered = MockDevice::write(wrench); }
};

Outcome wobble(const char* device_name, double rate, bool encoder, bool passive, const Wobble& wobble) {
  SimulationConfig config;
  config.contact_time = ContactTime::end;
  Simulation simulation(build_block({Vec3(-14, -14, -2) * mm, Vec3(14, 14, 0) * mm}, 0.1 * mm, presets::enamel()),
                        Tool(SphereHead{kRadius}, RayHandle{kHandle}, common_spindle(0)), config);
  MockOptions mock;
  mock.device = device_model(device_name);
  mock.hand = hand_model("light");
  mock.rigid = false;
  mock.encoder = encoder;
  mock.path = [&](double t) {
    const double down = std::clamp((t - kBegin) / (kTouch - kBegin), 0.0, 1.0);
    const double angle =
        wobble.angle * std::clamp(2 * (t - kTouch), 0.0, 1.0) * std::sin(2 * kPi * wobble.frequency * (t - kTouch));
    Pose X_BS;
    X_BS.rotation = rotation_from_vector(Vec3(0.3 * angle, angle, 0));
    const Vec3 from_tip = wobble.about_tip ? Vec3(X_BS.rotation * Vec3(0, 0, kHandle)) : Vec3(0, 0, kHandle);
    X_BS.translation = Vec3(0, 0, kRadius + 2 * mm - 5.5 * mm * down - kHandle) + from_tip;
    return X_BS;
  };
  Watched device(mock);
  SimulationModelOptions options;
  options.coupling = coupling_gains(device.capabilities());
  options.map.X_WB = Pose::from_translation(Vec3(0, 0, kHandle));
  SimulationModel model(simulation, device, options);
  RunOptions run;
  run.simulated_time = true;
  run.stop_on_signals = false;
  run.seconds = kEnd;
  run.guard.period = 1 / rate;
  run.guard.passivity.enabled = passive;

  LoopSnapshot snapshot;
  Outcome seen;
  Vec3 commanded = Vec3::Zero(), applied = Vec3::Zero(), hand = Vec3::Zero();
  int ticks = 0;
  (void)device.run(
      [&](const DeviceState& state) {
        DeviceCommand command;
        command.wrench = model.step(state, 1 / rate, snapshot);
        command.contact = model.contact();
        const DeviceOutput& output = device.last_output();
        const Vec3 moved = device.plant().pose().translation - hand;
        if (state.time > kWatched) {
          const double change = (output.commanded.force - commanded).norm();
          const double after = (output.applied.force - applied).norm();
          seen.commanded = std::max(seen.commanded, change);
          seen.applied = std::max(seen.applied, after);
          seen.most_added = std::max(seen.most_added, after - change);
          seen.mean += output.commanded.force.norm();
          seen.work += device.rendered.force.dot(moved);
          ++ticks;
        }
        commanded = output.commanded.force;
        applied = output.applied.force;
        hand = device.plant().pose().translation;
        return command;
      },
      run);
  seen.mean /= std::max(1, ticks);
  return seen;
}

constexpr double kRates[] = {250, 1000, 4000, 8000};  // [Hz]
constexpr const char* kDevices[] = {"touch", "premium15", "omega", "premium6dof"};
const Wobble kWobbles[] = {{2 * kPi / 180, 1, true}, {2 * kPi / 180, 1, false}, {15 * kPi / 180, 0.7, true}};

/// The outcomes of all devices, rates and wobbles.
void for_each_outcome(bool encoder, const std::function<void(const Outcome&)>& check) {
  for (const char* device : kDevices)
    for (const double rate : kRates)
      for (const Wobble& w : kWobbles) {
        SCOPED_TRACE(std::string(device) + " at " + std::to_string(rate) + " Hz, " + std::to_string(w.angle) + " rad");
        check(wobble(device, rate, encoder, true, w));
      }
}

TEST(SmoothGuard, AddsLittleToASmoothForceOfAStandingTool) {
  for_each_outcome(false, [](const Outcome& seen) {
    EXPECT_LE(seen.most_added, kMaxAdded);
    EXPECT_LE(seen.applied, seen.commanded + kMaxAdded);
  });
}

// The steps of the encoders make the force of the coupling itself rough, by up to 0.35 N per tick.
TEST(SmoothGuard, AddsLittleToTheStepsOfEncoders) {
  for_each_outcome(true, [](const Outcome& seen) { EXPECT_LE(seen.applied, 1.05 * seen.commanded + kMaxAdded); });
}

// The head sticks, so the force of a fast hand changes as at a wall: by up to 0.3 N per tick.
TEST(SmoothGuard, AddsLittleToTheForceOfAFastTurn) {
  for (const char* device : kDevices)
    for (const double rate : kRates) {
      SCOPED_TRACE(std::string(device) + " at " + std::to_string(rate) + " Hz");
      for (const bool encoder : {false, true}) {
        const Outcome seen = wobble(device, rate, encoder, true, {10 * kPi / 180, 4, false});
        EXPECT_LE(seen.applied, 1.05 * seen.commanded + kMaxAdded);
      }
    }
}

// Without motors for torque, the turn of the stylus would give energy to the hand.
TEST(SmoothGuard, KeepsTheEnergyOfTheTurnFromTheHand) {
  const Wobble large{30 * kPi / 180, 0.7, true};
  for (const char* device : {"touch", "premium15", "omega"})
    for (const double rate : kRates)
      for (const bool encoder : {false, true}) {
        SCOPED_TRACE(std::string(device) + " at " + std::to_string(rate) + " Hz");
        const Outcome bare = wobble(device, rate, encoder, false, large);
        const Outcome guarded = wobble(device, rate, encoder, true, large);
        EXPECT_GT(bare.mean, 0.05);
        EXPECT_GT(bare.work, 5e-3);
        EXPECT_LT(guarded.work, (rate < 1000 ? 0.35 : 0.05) * bare.work);
      }
}

}  // namespace
}  // namespace hapticut::smooth_guard_test
