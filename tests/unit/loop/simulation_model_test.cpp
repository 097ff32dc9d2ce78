// SPDX-License-Identifier: Apache-2.0
#include "hapticut/loop/simulation_model.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <chrono>
#include <functional>
#include <map>
#include <memory>
#include <string>
#include <thread>

#include "experiments/setup/cutting.hpp"
#include "hapticut/core/errors.hpp"
#include "hapticut/device/simulated/mock.hpp"
#include "hapticut/force/laws/foundation.hpp"
#include "hapticut/workpiece/builders.hpp"
#include "support/refusal.hpp"
#include "support/sanitizers.hpp"
#include "support/scripted_loop.hpp"

namespace hapticut::simulation_model_test {
namespace {

constexpr double kRadius = 1.5e-3;  // [m] radius of the ball

// The thread sanitizer makes a tick thirty times slower, so fewer ticks have to suffice.
constexpr std::uint64_t kManyTicks = test::kWithThreadSanitizer ? 5000 : 20000;
constexpr std::uint64_t kSomeTicks = test::kWithThreadSanitizer ? 2500 : 5000;

/// A block whose upper face the ball touches when the stylus is at the origin of its base.
Simulation block_under_the_ball(double spindle_speed = 3000, ContactTime contact_time = ContactTime::middle) {
  SimulationConfig config;
  config.contact_time = contact_time;
  config.reference_stiffness = 1e13;
  config.reserved_blocks = 4096;
  return {build_block({Vec3(-14e-3, -14e-3, -8e-3), Vec3(14e-3, 14e-3, 0)}, 2e-4, test::plain_material()),
          Tool(SphereHead{kRadius}, RayHandle{0}, Spindle{spindle_speed * units::rad_per_s}), config};
}

SimulationModelOptions ball_above_the_block() {
  SimulationModelOptions options;
  options.map.X_WB = Pose::from_translation(Vec3(0, 0, kRadius));
  return options;
}

RealtimeLoopOptions options_for(const SimulationModel& model, double seconds) {
  RealtimeLoopOptions options;
  options.run = test::scripted_loop::simulated_run();
  options.run.seconds = seconds;
  options.run.guard.arming.ramp = options.run.guard.arming.short_ramp = 0.05;
  options.region = model.region();
  options.block_capacity = 8;  // too small for a slow reader
  options.blocks_per_tick = 4;
  return options;
}

using Picture = std::map<VoxelIndex, ChangedBlock>;

void expect_same(const Picture& picture, const Picture& expected) {
  ASSERT_EQ(picture.size(), expected.size());
  for (const auto& [origin, content] : expected) {
    ASSERT_EQ(picture.at(origin).material, content.material);
    ASSERT_EQ(picture.at(origin).fill, content.fill);
  }
}

Picture picture_of(const Workpiece& workpiece) {
  Picture picture;
  workpiece.for_each_block([&](const BlockView& view) {
    ChangedBlock& block = picture[view.origin];
    block.origin = view.origin;
    copy_block(workpiece, block);
  });
  return picture;
}

/// Applies a command between two ticks, without a queue.
bool apply(SimulationModel& model, LoopCommand command) {
  model.check(command);
  return model.apply(command);
}

bool is_empty(const ChangedBlock& block) {
  return std::all_of(block.material.begin(), block.material.end(), [](MaterialId id) { return id == kEmpty; });
}

// A device of 700 N/m must not render a contact of 16 kN/m, or of the default stiffness.
TEST(SimulationModel, RefusesToDriveADeviceDirectlyWithAStiffnessThatItCannotRender) {
  const auto device = open_device("mock:rest");
  const auto refusal = [&](double stiffness) -> std::string {
    SimulationConfig config;
    config.reference_stiffness = stiffness;
    Simulation simulation(build_block({Vec3::Constant(-2e-3), Vec3::Constant(2e-3)}, 2e-4, test::plain_material()),
                          Tool(SphereHead{kRadius}), config);
    try {
      (void)SimulationModel(simulation, *device, ball_above_the_block());
    } catch (const Error& error) {
      return error.what();
    }
    return "";
  };
  EXPECT_NE(refusal(0).find("driven directly"), std::string::npos);
  EXPECT_NE(refusal(1e13).find("lower the reference stiffness to 4.4"), std::string::npos);
  EXPECT_EQ(refusal(4.4e11), "");
}

TEST(SimulationModel, RefusesACouplingThatTheDeviceCannotRender) {
  const auto device = open_device("mock:rest");  // 700 N/m
  Simulation simulation = block_under_the_ball(3000, ContactTime::end);
  SimulationModelOptions options = ball_above_the_block();
  options.coupling = test::scripted_loop::touch_gains();
  options.coupling->stiffness = 1400;
  EXPECT_NO_THROW((void)SimulationModel(simulation, *device, options));
  options.coupling->stiffness = 20e3;
  test::expect_refused([&] { (void)SimulationModel(simulation, *device, options); }, "at most 1400 N/m");
}

// Stress test: simulated seconds of cutting at full speed, with commands. A reader that polls 60 times a second keeps a
// picture of the workpiece from changed blocks only. In the end the picture equals the workpiece.
TEST(SimulationModel, KeepsThePictureOfASlowReaderComplete) {
  const auto device = test::scripted_loop::stiff_mock("spiral");
  Simulation simulation = block_under_the_ball();
  Picture picture = picture_of(simulation.workpiece());
  SimulationModel model(simulation, *device, ball_above_the_block());
  RealtimeLoop loop(*device, model, options_for(model, 0));
  std::uint64_t version = 0, tick = 0;
  double removed = 0;
  std::size_t max_waiting = 0;
  ChangedBlock block;
  const auto look = [&] {
    const LoopSnapshot& snapshot = loop.latest();
    const ToolSnapshot tool = snapshot.tool;
    EXPECT_GE(snapshot.tick, tick);
    EXPECT_GE(tool.removed_volume, removed);
    tick = snapshot.tick;
    removed = tool.removed_volume;
    max_waiting = std::max(max_waiting, snapshot.blocks_waiting);
    while (loop.receive(block)) {
      EXPECT_GT(block.version, version);
      version = block.version;
      ChangedBlock& shown = picture[block.origin];
      EXPECT_TRUE(std::ranges::equal(block.fill, shown.fill, std::less_equal<float>{})) << "blocks only lose material";
      shown = block;
    }
    return snapshot.blocks_waiting;
  };
  loop.start();
  while (tick < kManyTicks) {
    look();
    loop.send(commands::SetSpindleSpeed{3000 * units::rad_per_s});
    std::this_thread::sleep_for(std::chrono::milliseconds(16));
  }
  // The spindle stops: nothing more is cut, and the waiting blocks are sent.
  loop.send(commands::SetSpindleSpeed{0});
  for (int calm = 0; calm < 20;) {
    calm = look() == 0 && loop.latest().tool.spindle_speed == 0 ? calm + 1 : 0;
    std::this_thread::sleep_for(std::chrono::milliseconds(1));
  }
  const RunReport report = loop.stop();
  while (loop.receive(block)) picture[block.origin] = block;

  EXPECT_EQ(report.fault, DeviceFault::none);
  EXPECT_GT(removed, 5e-15 * kManyTicks);  // [m^3]
  EXPECT_GT(max_waiting, 0U);              // the reader was too slow, as intended
  std::erase_if(picture, [](const auto& entry) { return is_empty(entry.second); });
  expect_same(picture, picture_of(simulation.workpiece()));
}

TEST(SimulationModel, RendersTheForceOfTheSimulationOnTheDevice) {
  const auto device = test::scripted_loop::stiff_mock("press", 2);
  Simulation simulation = block_under_the_ball(0);
  SimulationModel model(simulation, *device, ball_above_the_block());
  RealtimeLoopOptions options = options_for(model, 0);
  RealtimeLoop loop(*device, model, options);
  loop.start();
  const RunReport report = loop.wait();
  const ToolSnapshot tool = loop.latest().tool;
  EXPECT_EQ(tool.steps, report.ticks);
  EXPECT_GT(tool.force.z(), 1);
  EXPECT_EQ(tool.force, simulation.last_result().force);
  EXPECT_EQ(device->output().commanded.force, tool.force);
  EXPECT_LE(device->output().applied.force.norm(), device->capabilities().peak_force);
  EXPECT_EQ(tool.removed_volume, 0);
}

TEST(SimulationModel, HoldsTheToolOnTheSurfaceWhileTheHandMovesOn) {
  // The hand goes 5 mm below the face; the material is a thousand times stiffer than the device.
  const auto device = test::scripted_loop::stiff_mock("press", 3);
  SimulationConfig config;
  config.reference_stiffness = 1e16;
  config.contact_time = ContactTime::end;
  Simulation simulation(build_block({Vec3(-14e-3, -14e-3, -8e-3), Vec3(14e-3, 14e-3, 0)}, 2e-4, test::plain_material()),
                        Tool(SphereHead{kRadius}), config);
  SimulationModelOptions options = ball_above_the_block();
  options.coupling = test::scripted_loop::touch_gains();
  SimulationModel model(simulation, *device, options);
  RealtimeLoop loop(*device, model, options_for(model, 0));
  loop.start();
  loop.wait();
  EXPECT_LT(device->state().X_BS.translation.z(), -4.9e-3);
  EXPECT_NEAR(loop.latest().X_WT.translation.z(), kRadius, 2e-4);  // a voxel
  EXPECT_NEAR(loop.latest().tool.force.norm(), options.coupling->max_force, 0.01);
  EXPECT_EQ(device->output().commanded.force, loop.latest().tool.force);
}

TEST(SimulationModel, CutsNothingBeforeTheToolWasFree) {
  // The ball starts half inside the block, or completely inside, where its springs are in balance, and stays there.
  for (const double height : {-0.5e-3, -3e-3})
    for (const bool needs_force : {true, false}) {
      const auto device = test::scripted_loop::stiff_mock("rest", 1);
      Simulation simulation = block_under_the_ball();
      SimulationModelOptions options;
      options.map.X_WB = Pose::from_translation(Vec3(0, 0, height));
      options.spindle_needs_force = needs_force;
      SimulationModel model(simulation, *device, options);
      RealtimeLoop loop(*device, model, options_for(model, 0));
      loop.start();
      const RunReport report = loop.wait();
      const ToolSnapshot tool = loop.latest().tool;
      EXPECT_GT(tool.contact_voxels, 0);
      EXPECT_EQ(tool.removed_volume == 0, needs_force) << height;
      EXPECT_EQ(tool.spindle_speed == 0, needs_force) << height;
      if (needs_force && height > -1e-3) {
        EXPECT_GT(report.events[std::size_t(SafetyEvent::start_inside)], 0U);
      }
    }
}

TEST(SimulationModel, StopsTheSpindleInAnEmergencyFromAnyThread) {
  const auto device = test::scripted_loop::stiff_mock("spiral");
  Simulation simulation = block_under_the_ball();
  SimulationModel model(simulation, *device, ball_above_the_block());
  RealtimeLoop loop(*device, model, options_for(model, 0));
  loop.start();
  while (loop.latest().tool.removed_volume == 0) std::this_thread::yield();
  while (loop.send(commands::OpenClutch{}) && loop.send(commands::CloseClutch{})) {  // until the queue is full
  }
  std::thread a([&] { loop.requests().emergency_stop(); }), b([&] { loop.requests().emergency_stop(); });
  a.join();
  b.join();
  while (loop.latest().arming != ArmingState::fault) std::this_thread::yield();
  while (loop.latest().tool.spindle_speed != 0) std::this_thread::yield();
  EXPECT_TRUE(device->output().applied.force.isZero(0));
  const double removed = loop.latest().tool.removed_volume;
  const std::uint64_t tick = loop.latest().tick;
  while (loop.latest().tick < tick + 500) std::this_thread::yield();
  EXPECT_EQ(loop.latest().tool.removed_volume, removed);
  EXPECT_GE(loop.stop().events[std::size_t(SafetyEvent::emergency_stop)], 1U);
}

TEST(SimulationModel, AppliesClutchAndScale) {
  const auto device = test::scripted_loop::stiff_mock("line");
  Simulation simulation = block_under_the_ball(0);
  SimulationModelOptions options = ball_above_the_block();
  options.map.X_WB.translation.z() += 20e-3;  // starts in the air
  SimulationModel model(simulation, *device, options);
  RealtimeLoop loop(*device, model, options_for(model, 0));
  loop.start();
  const auto ticks = [&](std::uint64_t count) {
    const std::uint64_t begin = loop.latest().tick;
    while (loop.latest().tick < begin + count) std::this_thread::yield();
  };
  ticks(3000);
  loop.send(commands::OpenClutch{});
  ticks(5);
  const Vec3 held = loop.latest().X_WT.translation;
  ticks(700);
  EXPECT_EQ(loop.latest().X_WT.translation, held);
  loop.send(commands::CloseClutch{});
  ticks(700);
  EXPECT_NE(loop.latest().X_WT.translation, held);
  EXPECT_THROW((void)loop.send(commands::SetScale{-1}), Error);
  loop.send(commands::SetScale{0.5});
  ticks(10);
  EXPECT_THROW((void)loop.send(commands::SetSpindleSpeed{std::nan("") * units::rad_per_s}), Error);
  ticks(10);
  const RunReport report = loop.stop();
  EXPECT_EQ(report.events[std::size_t(SafetyEvent::reclutched)], 2U);
  EXPECT_EQ(report.fault, DeviceFault::none);
  EXPECT_EQ(simulation.spindle().setting(), 0);
}

// A mark, simulated seconds of cutting, and an undo while the loop runs: a slow reader of changed blocks ends up with
// the workpiece at the mark.
TEST(SimulationModel, UndoesACutWhileTheLoopRunsAndSendsItsBlocks) {
  for (const bool coupled : {false, true}) {
    const auto device = test::scripted_loop::stiff_mock("spiral");
    Simulation simulation = block_under_the_ball(3000, coupled ? ContactTime::end : ContactTime::middle);
    const Picture at_mark = picture_of(simulation.workpiece());
    Picture picture = at_mark;
    SimulationModelOptions options = ball_above_the_block();
    options.undo_blocks = 4096;
    options.undo_blocks_per_tick = 1;
    if (coupled) options.coupling = test::scripted_loop::touch_gains();
    SimulationModel model(simulation, *device, options);
    RealtimeLoop loop(*device, model, options_for(model, 0));
    const auto look = [&] {
      const LoopSnapshot& snapshot = loop.latest();
      for (ChangedBlock block; loop.receive(block);) picture[block.origin] = block;
      return snapshot;
    };
    loop.send(commands::SetUndoMark{});
    loop.start();
    while (look().tick < kSomeTicks) std::this_thread::sleep_for(std::chrono::milliseconds(2));
    EXPECT_GT(loop.latest().tool.removed_volume, 1e-9);
    EXPECT_EQ(loop.latest().tool.undo_marks, 1U);
    loop.send(commands::SetSpindleSpeed{0});
    loop.send(commands::Undo{});
    loop.send(commands::Undo{});         // refused during the first one
    loop.send(commands::SetUndoMark{});  // refused too
    for (int calm = 0; calm < 20;) {
      const LoopSnapshot snapshot = look();
      const ToolSnapshot tool = snapshot.tool;
      calm = tool.undo_marks == 0 && !tool.undoing && snapshot.blocks_waiting == 0 ? calm + 1 : 0;
      std::this_thread::sleep_for(std::chrono::milliseconds(1));
    }
    const RunReport report = loop.stop();
    (void)look();

    EXPECT_EQ(report.fault, DeviceFault::none);
    EXPECT_GT(report.events[std::size_t(SafetyEvent::model_swapped)], 10U) << "the guard handles each part of the undo";
    const Picture now = picture_of(simulation.workpiece());
    ASSERT_EQ(now.size(), at_mark.size());
    for (const auto& [origin, content] : at_mark) {
      ASSERT_EQ(picture.at(origin).fill, content.fill);
      ASSERT_EQ(picture.at(origin).material, content.material);
      ASSERT_EQ(now.at(origin).fill, content.fill);
    }
  }
}

TEST(SimulationModel, GivesNoForceFromAnUndoUntilTheToolWasFree) {
  // The hand stays in the drilled hole, and the undo fills the hole around it.
  const auto device = test::scripted_loop::stiff_mock("rest");
  Simulation simulation = block_under_the_ball();
  const double whole = simulation.workpiece().amounts()[0].volume;
  SimulationModelOptions options = ball_above_the_block();
  options.map.X_WB.translation.z() += 1e-3;
  options.undo_blocks = 4096;
  options.undo_blocks_per_tick = 1;
  SimulationModel model(simulation, *device, options);
  LoopSnapshot snapshot;
  int ticks = 0, without_force = 0;
  RunOptions run = test::scripted_loop::simulated_run();
  run.guard.arming.ramp = run.guard.arming.short_ramp = 0.05;
  apply(model, commands::SetUndoMark{});
  (void)device->run(
      [&](const DeviceState& reading) {
        DeviceState state = reading;
        // Moves down by 1.6 mm in 0.4 s, and stays there.
        state.X_BS.translation.z() -= 4e-6 * std::clamp(ticks - 200, 0, 400);
        if (ticks == 700) {
          EXPECT_GT(snapshot.tool.removed_volume, 0);
          EXPECT_EQ(device->last_arming(), ArmingState::on);
          apply(model, commands::Undo{});
        }
        DeviceCommand command{model.step(state, 1e-3, snapshot), false, model.contact()};
        if (const ToolSnapshot tool = snapshot.tool; ticks > 700 && tool.undoing) {
          EXPECT_TRUE(command.wrench.force.isZero(0));
          EXPECT_TRUE(tool.force.isZero(0) && tool.torque.isZero(0));
          EXPECT_EQ(tool.contact_voxels + tool.contact_depth + tool.spindle_speed, 0);
          EXPECT_EQ(tool.status, StepStatus::ok);
          EXPECT_EQ(tool.undo_marks, 1U);
          EXPECT_GT(tool.removed_volume, 0) << "the removed volume still counts the cut";
          EXPECT_TRUE(snapshot.X_WT.translation.isApprox(options.map.X_WB.translation + state.X_BS.translation))
              << "the tool is shown at the hand";
          ++without_force;
        }
        if (ticks > 702) {
          EXPECT_EQ(device->last_arming(), ArmingState::wait_free) << ticks;
          EXPECT_TRUE(device->last_output().applied.force.isZero(0)) << ticks;
          if (ticks > 760) {  // the undo has ended
            EXPECT_EQ(snapshot.tool.spindle_speed, 0);
          }
        }
        command.stop = ++ticks > 1500;
        return command;
      },
      run);
  EXPECT_GT(without_force, 1);
  EXPECT_TRUE(has_any(snapshot.tool.status, StepStatus::tool_waits)) << "the tool is in the material again";
  EXPECT_EQ(simulation.workpiece().amounts()[0].volume, whole);
}

TEST(SimulationModel, IgnoresReadingsThatMeanNothing) {
  const auto device = test::scripted_loop::stiff_mock("rest");
  Simulation simulation = block_under_the_ball();
  SimulationModel model(simulation, *device, ball_above_the_block());
  LoopSnapshot snapshot;
  DeviceState state;
  state.valid = false;
  // Device::last_output may only be called in a run, so the step must end before.
  EXPECT_TRUE(model.step(state, 1e-3, snapshot).force.isZero(0));
  EXPECT_EQ(simulation.steps(), 0U);
}

}  // namespace
}  // namespace hapticut::simulation_model_test
