// SPDX-License-Identifier: Apache-2.0
// The spindle of a loop runs only with a force, and with a pedal only while the pedal is down.
#include "hapticut/loop/spindle_interlock.hpp"

#include <gtest/gtest.h>

#include "hapticut/core/errors.hpp"
#include "support/scripted_loop.hpp"

namespace hapticut::spindle_interlock_test {
namespace {

using namespace test::scripted_loop;

TEST(SpindleInterlock, CutsNothingThatTheHandCannotFeelInACustomLoop) {
  for (const bool interlocked : {true, false}) {
    const std::unique_ptr<Device> device = stiff_mock("rest");
    Simulation simulation(block(), ball(), config(true));
    VirtualCoupling coupling(simulation, touch_gains());
    SpindleInterlock interlock;
    double unfelt = 0, felt = 0;  // [m^3]
    int n = 0;
    (void)device->run(
        [&](const DeviceState& state) {
          // The ball is pressed in without a force, out at tick 300, and in at tick 2500 with a force.
          const double depth = n < 300    ? 1e-5 * std::min(n - 8, 100)
                               : n < 2500 ? -2e-3
                                          : 1e-5 * std::min(n - 2500, 100);
          const Pose pose = Pose::from_translation(Vec3(0, 0, kRadius - depth));
          if (interlocked) interlock.update(simulation, device->last_arming());
          const CoupledResult& result = coupling.step(pose, {}, device->period());
          (n < 300 ? unfelt : felt) += result.removed_volume;
          (void)state;
          return DeviceCommand{result.hand, ++n >= 3000};
        },
        simulated_run());
    EXPECT_EQ(unfelt > 0, !interlocked);
    EXPECT_GT(felt, 0) << "once there is a force";
  }
}

TEST(SpindleInterlock, WaitsUntilTheToolHasTouchedNothing) {
  SpindleInterlock interlock;
  EXPECT_FALSE(interlock.admits(ArmingState::wait_free, false));
  EXPECT_FALSE(interlock.admits(ArmingState::ramp, true));
  EXPECT_TRUE(interlock.admits(ArmingState::ramp, false));
  EXPECT_TRUE(interlock.admits(ArmingState::on, true)) << "with a force the tool may touch the material";
  EXPECT_FALSE(interlock.admits(ArmingState::fault, true));
  EXPECT_FALSE(interlock.admits(ArmingState::on, true));
  EXPECT_TRUE(interlock.admits(ArmingState::on, false));
  interlock.interrupt();
  EXPECT_FALSE(interlock.admits(ArmingState::on, true));
}

// Regression: the interlock once set the speed setting to 0, so the next loop cut nothing.
TEST(SpindleInterlock, KeepsTheSpeedSettingOfTheSpindle) {
  Simulation simulation(block(), ball(), config(true));
  const AngularSpeed speed = simulation.spindle().setting();
  ASSERT_GT(speed, 0);
  SpindleInterlock interlock;
  const auto speed_of_step = [&] {
    return simulation.step(Pose::from_translation(Vec3(0, 0, 5e-3)), {}, 1e-3).spindle.speed;
  };
  interlock.update(simulation, ArmingState::wait_free);
  EXPECT_TRUE(simulation.spindle().is_held());
  EXPECT_EQ(speed_of_step(), 0);
  EXPECT_EQ(simulation.spindle().setting(), speed);
  simulation.spindle().set_speed(0.5 * speed);
  EXPECT_EQ(speed_of_step(), 0);
  interlock.update(simulation, ArmingState::on);
  EXPECT_EQ(speed_of_step(), 0.5 * speed) << "the speed that was set meanwhile";
  simulation.spindle().set_speed(speed);
  interlock.update(simulation, ArmingState::on);
  EXPECT_EQ(speed_of_step(), speed) << "the speed stays";
  simulation.spindle().hold(true);
  simulation.set(ball());
  EXPECT_EQ(speed_of_step(), 0);
  simulation.reset(block());
  EXPECT_EQ(speed_of_step(), 0);
  Simulation prepared(block(), ball(), config(true));
  simulation.exchange(prepared);
  EXPECT_EQ(speed_of_step(), 0);
  EXPECT_FALSE(prepared.spindle().is_held()) << "the replaced spindle is not held";
  simulation.spindle().hold(false);
  EXPECT_EQ(speed_of_step(), ball().spindle().speed);
}

TEST(SpindleInterlock, OfAModelReleasesTheSpindleWhenTheModelIsDestroyed) {
  ScriptedLoop scripted;
  {
    SimulationModel model(scripted.simulation, *scripted.device);
    LoopSnapshot snapshot;
    (void)scripted.device->run(
        [&](const DeviceState& state) {
          return DeviceCommand{model.step(state, 1e-3, snapshot), true};
        },
        simulated_run());
    EXPECT_TRUE(scripted.simulation.spindle().is_held()) << "there was no force yet";
  }
  EXPECT_FALSE(scripted.simulation.spindle().is_held());
}

TEST(SpindleInterlock, OfAModelWithAPedalTurnsWhileItIsDown) {
  ScriptedLoop scripted;
  SimulationModelOptions options;
  options.map.X_WB = Pose::from_translation(Vec3(0, 0, kRadius));
  options.pedal = 32;
  EXPECT_THROW(SimulationModel(scripted.simulation, *scripted.device, options), Error);
  options.pedal = 3;
  SimulationModel model(scripted.simulation, *scripted.device, options);
  RunOptions run = simulated_run();
  run.guard.arming.ramp = run.guard.arming.short_ramp = 0.02;
  LoopSnapshot snapshot;
  int touched = 0;      // [voxels] number in contact before the pedal goes down; -1: something was removed
  double removed = -1;  // [m^3] when the pedal comes up
  int n = 0;
  (void)scripted.device->run(
      [&](const DeviceState& reading) {
        DeviceState state = reading;
        state.X_BS.translation = {0, 0, 1e-3 - 1.5e-6 * n};  // touches from tick 667 on
        state.buttons = n < 800 || n >= 900 ? ~(1U << 3) : 1U << 3;
        DeviceCommand command{model.step(state, 1e-3, snapshot), false, model.contact()};
        if (n == 799) touched = snapshot.tool.removed_volume == 0 ? snapshot.tool.contact_voxels : -1;
        if (n == 899) removed = snapshot.tool.removed_volume;
        command.stop = ++n == 1000;
        return command;
      },
      run);
  EXPECT_GT(touched, 0);
  EXPECT_GT(removed, 0);
  EXPECT_EQ(snapshot.tool.removed_volume, removed);
}

}  // namespace
}  // namespace hapticut::spindle_interlock_test
