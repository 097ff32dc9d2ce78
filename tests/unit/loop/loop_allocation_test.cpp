// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <array>
#include <random>
#include <variant>

#include "experiments/setup/cutting.hpp"
#include "hapticut/device/simulated/mock.hpp"
#include "hapticut/loop/change_feed.hpp"
#include "hapticut/loop/realtime_loop.hpp"
#include "hapticut/loop/simulation_model.hpp"
#include "hapticut/tool/catalogue.hpp"
#include "hapticut/workpiece/builders.hpp"
#include "support/allocation_count.hpp"
#include "support/random_commands.hpp"
#include "support/scripted_loop.hpp"

namespace hapticut::loop_allocation_test {
namespace {

RunOptions quick() {
  RunOptions options;
  options.stop_on_signals = false;
  options.guard.arming.ramp = options.guard.arming.short_ramp = 0.05;
  return options;
}

/// A simulation in a loop that cuts, sets marks, and is undone and redone repeatedly, with changed blocks being sent.
struct UndoingLoop {
  explicit UndoingLoop(bool coupled)
      : simulation(build_block({Vec3(-14e-3, -14e-3, -8e-3), Vec3(14e-3, 14e-3, 0)}, 2e-4, test::plain_material()),
                   Tool(SphereHead{kRadius}, RayHandle{0}, Spindle{3000 * units::rad_per_s}), config(coupled)),
        model(simulation, *device, options(coupled)),
        feed(simulation, model.region(), 64) {}

  static SimulationConfig config(bool coupled) {
    SimulationConfig config;
    config.reference_stiffness = 1e13;
    config.reserved_blocks = 4096;
    config.contact_time = coupled ? ContactTime::end : ContactTime::middle;
    return config;
  }
  SimulationModelOptions options(bool coupled) const {
    SimulationModelOptions options;
    options.map.X_WB = Pose::from_translation(Vec3(0, 0, kRadius));
    options.undo_blocks = 500;  // fewer than are cut, so that marks are dropped
    options.undo_blocks_per_tick = 1;
    if (coupled) options.coupling = test::scripted_loop::touch_gains();
    return options;
  }
  DeviceCommand tick(const DeviceState& state) {
    ++ticks;
    if (ticks == 100) test::arm_call_counts();
    if (ticks % 500 == 1 && ticks % 2000 > 1000) (void)model.apply(mark);
    if (ticks % 2000 == 1999) (void)model.apply(undo);
    if (ticks % 4000 == 2199) (void)model.apply(redo);
    const DeviceCommand command{model.step(state, 1e-3, snapshot), ticks >= 9000, model.contact()};
    feed.tick(16, snapshot.tool.workpiece);
    undo_ticks += snapshot.tool.undoing ? 1 : 0;
    redo_ticks += snapshot.tool.redoing ? 1 : 0;
    if (ticks == 8990) counts = test::disarm_call_counts();
    return command;
  }

  static constexpr double kRadius = 1.5e-3;  // [m]
  std::unique_ptr<Device> device = test::scripted_loop::stiff_mock("spiral");
  Simulation simulation;
  SimulationModel model;
  ChangeFeed feed;
  LoopSnapshot snapshot;
  LoopCommand mark = commands::SetUndoMark{}, undo = commands::Undo{}, redo = commands::Redo{};
  test::CallCounts counts;
  int ticks = 0, undo_ticks = 0, redo_ticks = 0;
};

TEST(LoopOfASimulation, AllocatesNothingAndTakesNoLockDuringUndoAndRedo) {
  for (const bool coupled : {false, true}) {
    UndoingLoop loop(coupled);
    loop.feed.attach();
    RunOptions options = quick();
    options.simulated_time = true;
    (void)loop.device->run([&](const DeviceState& state) { return loop.tick(state); }, options);
    EXPECT_EQ(loop.ticks, 9000);
    EXPECT_EQ(loop.counts.allocations, 0);
    EXPECT_EQ(loop.counts.deallocations, 0);
    EXPECT_EQ(loop.counts.locks, 0);
    EXPECT_GT(loop.undo_ticks, 10) << "there must be an undo, or the test proves nothing";
    EXPECT_GT(loop.redo_ticks, 0) << "and a redo";
    EXPECT_GT(loop.snapshot.tool.removed_volume, 1e-9);
  }
}

/// Commands of every kind, prepared beforehand, to a RealtimeLoop whose ticks count allocations and locks.
TEST(LoopOfASimulation, AllocatesNothingAndTakesNoLockForAnyCommand) {
  constexpr int kTicks = 9000;
  /// Wraps a SimulationModel and counts in the thread of the loop, from its first tick on.
  class WatchedModel final : public LoopModel {
   public:
    explicit WatchedModel(SimulationModel& model) : model_(&model) {}
    bool apply(LoopCommand& command) noexcept override {
      const bool applied = model_->apply(command);
      (applied ? applied_ : refused_)[command.index()] += 1;
      return applied;
    }
    Wrench step(const DeviceState& state, double dt, LoopSnapshot& snapshot) noexcept override {
      if (++ticks_ == 1) test::arm_call_counts();
      const Wrench wrench = model_->step(state, dt, snapshot);
      if (ticks_ == kTicks - 10) counts_ = test::disarm_call_counts();
      return wrench;
    }
    [[nodiscard]] Simulation* simulation() noexcept override { return model_->simulation(); }

    SimulationModel* model_;
    int ticks_ = 0;
    std::array<int, std::variant_size_v<LoopCommand>> applied_{}, refused_{};
    test::CallCounts counts_;
  };
  for (const bool coupled : {false, true}) {
    UndoingLoop parts(coupled);  // only its device, simulation and model are used
    WatchedModel watched(parts.model);
    RealtimeLoopOptions options;
    options.run = quick();
    options.run.simulated_time = true;
    options.run.seconds = 1e-3 * kTicks;
    options.region = parts.model.region();
    RealtimeLoop loop(*parts.device, watched, options);
    // Part of the commands is in the queue before the first tick; more follow while the loop runs.
    std::mt19937 random(1);
    const auto between = [&](double low, double high) {
      return std::uniform_real_distribution<double>(low, high)(random);
    };
    auto next = [&, n = 0, described = std::size_t(0)]() mutable -> LoopCommand {
      const double radius = UndoingLoop::kRadius * (0.5 + 0.1 * (n % 10));
      const Spindle spindle{3000 * units::rad_per_s};
      switch (++n % 16) {
        case 0:
          return parts.model.prepare_tool(Tool(SphereHead{radius}, RayHandle{0}, spindle));
        case 4:
          return parts.model.prepare_tool(Tool(round_head(2 * radius), RayHandle{0}, spindle));
        case 8:
          return parts.model.prepare_materials(MaterialTable({test::plain_material()}));
        case 12:
          return parts.model.prepare_workpiece(
              build_block({Vec3(-14e-3, -14e-3, -8e-3), Vec3(14e-3, 14e-3, 0)}, 2e-4, test::plain_material()),
              Tool(SphereHead{radius}, RayHandle{0}, spindle));
        default:
          return test::random_command(described++ % test::kDescribedCommands, between);
      }
    };
    for (int n = 0; n < 64; ++n) ASSERT_TRUE(loop.send(next()));
    loop.start();
    while (loop.is_running()) {
      for (int n = 0; n < 16; ++n) (void)loop.send(next());
      for (ChangedBlock block; loop.receive(block);) {
      }
      (void)loop.latest();
    }
    (void)loop.wait();
    EXPECT_EQ(watched.counts_.allocations, 0);
    EXPECT_EQ(watched.counts_.deallocations, 0);
    EXPECT_EQ(watched.counts_.locks, 0);
    const LoopCommand undo = commands::Undo{}, redo = commands::Redo{};
    for (std::size_t kind = 0; kind < watched.applied_.size(); ++kind) {
      if (kind == undo.index() || kind == redo.index())
        continue;  // covered by the test above: here nothing is cut for long
      EXPECT_GT(watched.applied_[kind], 2) << kind;
    }
  }
}

}  // namespace
}  // namespace hapticut::loop_allocation_test
