// SPDX-License-Identifier: Apache-2.0
// Random commands of all kinds to a running loop, for the sanitizers.
#include <gtest/gtest.h>

#include <array>
#include <atomic>
#include <cmath>
#include <map>
#include <random>
#include <thread>
#include <utility>
#include <variant>

#include "experiments/setup/cutting.hpp"
#include "hapticut/device/simulated/device_models.hpp"
#include "hapticut/device/simulated/mock.hpp"
#include "hapticut/loop/coupling_gains.hpp"
#include "hapticut/loop/simulation_model.hpp"
#include "hapticut/tool/catalogue.hpp"
#include "hapticut/workpiece/builders.hpp"
#include "support/random_commands.hpp"

namespace hapticut::random_commands_test {
namespace {

constexpr double kRadius = 1.5e-3;  // [m] radius of the ball

/// Counts the commands that a SimulationModel applies and refuses.
class CountingModel final : public LoopModel {
 public:
  explicit CountingModel(SimulationModel& model) : model_(&model) {}
  Wrench step(const DeviceState& state, double dt, LoopSnapshot& snapshot) noexcept override {
    return model_->step(state, dt, snapshot);
  }
  void check(const LoopCommand& command) const override { model_->check(command); }
  bool apply(LoopCommand& command) noexcept override {
    const std::size_t kind = command.index();
    const bool applied = model_->apply(command);
    ++(applied ? applied_ : refused_)[kind];
    ++all_;
    return applied;
  }
  [[nodiscard]] Simulation* simulation() noexcept override { return model_->simulation(); }

  SimulationModel* model_;
  std::array<int, std::variant_size_v<LoopCommand>> applied_{}, refused_{};
  std::atomic<int> all_{0};
};

/// Moves in and out of the material repeatedly, at up to 30 mm/s.
Pose wandering(double t) {
  return Pose::from_translation({4e-3 * std::sin(5 * t), 4e-3 * std::cos(4 * t), 2e-3 * std::sin(3 * t)});
}

/// Sends a hundred thousand commands of all kinds to a cutting loop. The loop refuses some and never waits.
/// In the end every received block equals that of the workpiece.
void send_a_hundred_thousand(bool simulated_time, bool coupled, unsigned seed) {
  constexpr int kCommands = 100000;
  MockOptions hand;
  hand.path = wandering;
  hand.device = device_model("touch");
  if (!coupled) hand.device.rendered_stiffness = 1e6;  // so that it may be driven directly
  MockDevice a_device(hand);
  Device* const device = &a_device;
  SimulationConfig with;
  with.reference_stiffness = 1e13;
  with.contact_time = coupled ? ContactTime::end : ContactTime::middle;
  const auto coarse = [](double depth) {
    return build_block({Vec3(-8e-3, -8e-3, -depth), Vec3(8e-3, 8e-3, 0)}, 5e-4, test::plain_material());
  };
  const Tool ball(SphereHead{kRadius}, RayHandle{0}, Spindle{3000 * units::rad_per_s});
  Simulation simulation(coarse(5e-3), ball, with);
  SimulationModelOptions options;
  options.map.X_WB = Pose::from_translation(Vec3(0, 0, kRadius));
  options.undo_blocks = 300;  // fewer than are cut, so that marks are dropped
  options.undo_blocks_per_tick = 4;
  if (coupled) options.coupling = coupling_gains(device->capabilities());
  SimulationModel model(simulation, *device, options);
  CountingModel counting(model);
  RealtimeLoopOptions loop_options;
  loop_options.run.simulated_time = simulated_time;
  loop_options.run.stop_on_signals = false;
  loop_options.run.realtime.priority = 0;
  loop_options.run.realtime.lock_memory = false;
  loop_options.run.guard.arming.ramp = loop_options.run.guard.arming.short_ramp = 0.02;
  loop_options.region = {{-40, -40, -40}, {40, 40, 40}};  // around all workpieces of the test
  loop_options.block_capacity = 64;
  RealtimeLoop loop(*device, counting, loop_options);

  std::mt19937 random(seed);
  const auto number = [&](double low, double high) {
    return std::uniform_real_distribution<double>(low, high)(random);
  };
  const auto some_tool = [&] {
    const Spindle spindle{number(0, 5000) * units::rad_per_s};
    const double radius = number(0.6e-3, 2.5e-3);
    return random() % 2 == 0 ? Tool(SphereHead{radius}, RayHandle{number(0, 1e-3)}, spindle)
                             : Tool(round_head(2 * radius), RayHandle{0}, spindle);
  };
  const auto next = [&]() -> LoopCommand {
    const auto dice = random() % 1000;
    if (dice < 1) return model.prepare_workpiece(coarse(number(2e-3, 8e-3)), some_tool());
    if (dice < 2) return commands::SetTool(some_tool(), 1e-4, with);  // for another voxel size
    if (dice < 10) return model.prepare_tool(some_tool());
    if (dice < 30) {
      Material material = test::plain_material();
      material.relative_stiffness = number(0.5, 2);
      material.specific_cutting_energy = number(1e8, 1e9);
      return model.prepare_materials(MaterialTable({material}));
    }
    LoopCommand command = test::random_command(dice % test::kDescribedCommands, number);
    const bool opens = std::holds_alternative<commands::OpenClutch>(command);
    const bool restores =
        std::holds_alternative<commands::Undo>(command) || std::holds_alternative<commands::Redo>(command);
    // Most of the time the tool follows the hand and cuts.
    if ((opens && random() % 2 == 0) || (restores && random() % 10 != 0)) return commands::CloseClutch{};
    return command;
  };

  std::map<VoxelIndex, ChangedBlock> picture;
  ChangedBlock changed;
  std::uint32_t workpiece = 0;
  const auto look = [&] {
    const LoopSnapshot& seen = loop.latest();
    EXPECT_LE(seen.output.applied.force.norm(), device->capabilities().peak_force * (1 + 1e-9));
    EXPECT_FALSE(has_any(seen.tool.status_seen, StepStatus::force_not_finite | StepStatus::pose_rejected));
    while (loop.receive(changed)) {
      if (changed.workpiece != workpiece) picture.clear();
      workpiece = changed.workpiece;
      picture[changed.origin] = changed;
    }
    return seen;
  };
  loop.start();
  std::uint64_t dropped = 0;
  for (int sent = 0; sent < kCommands;) {
    // A burst of random length, then at least one tick.
    for (auto burst = random() % 250; burst > 0 && sent < kCommands; --burst) {
      LoopCommand command = next();
      while (!loop.send(std::move(command))) {
        ++dropped;
        std::this_thread::yield();
      }
      ++sent;
    }
    const std::uint64_t tick = look().tick;
    while (loop.latest().tick == tick) std::this_thread::yield();
  }
  loop.send(commands::SetRemoval{RemovalLaw::none});
  for (int calm = 0; calm < 20;) {
    const LoopSnapshot seen = look();
    const bool done = counting.all_ == kCommands + 1 && !seen.tool.undoing && !seen.tool.redoing;
    calm = done && seen.blocks_waiting == 0 ? calm + 1 : 0;
    const std::uint64_t tick = seen.tick;
    while (loop.latest().tick == tick) std::this_thread::yield();
  }
  const RunReport report = loop.stop();
  const LoopSnapshot last = look();

  EXPECT_EQ(report.fault, DeviceFault::none);
  EXPECT_NE(report.arming, ArmingState::fault);
  EXPECT_EQ(counting.all_, kCommands + 1);
  EXPECT_EQ(last.commands_dropped, dropped);
  EXPECT_EQ(last.blocks_outside, 0U);
  std::uint64_t refused = 0;
  for (std::size_t kind = 0; kind < counting.applied_.size(); ++kind) {
    EXPECT_GT(counting.applied_[kind], 20) << "of kind " << kind << "; send it in next() above";
    refused += std::uint64_t(counting.refused_[kind]);
  }
  EXPECT_EQ(last.commands_refused, refused);
  EXPECT_GT(refused, 50U);
  EXPECT_GT(report.events[std::size_t(SafetyEvent::model_swapped)], 100U);
  const LoopCommand exchange = model.prepare_workpiece(coarse(2e-3), ball);
  EXPECT_EQ(std::uint32_t(counting.applied_[exchange.index()]), last.tool.workpiece);

  // The received blocks of the last workpiece equal its blocks.
  if (workpiece == last.tool.workpiece)
    for (const auto& [origin, content] : picture) {
      ChangedBlock now;
      now.origin = origin;
      copy_block(simulation.workpiece(), now);
      ASSERT_EQ(content.material, now.material);
      ASSERT_EQ(content.fill, now.fill);
    }
  // The workpiece can still be undone and redone.
  const std::size_t marks = simulation.workpiece().marks();
  while (simulation.workpiece().marks() > 0)
    while (!simulation.history().undo(16)) {
    }
  EXPECT_GE(simulation.workpiece().redo_marks(), marks);
}

TEST(RandomCommands, AHundredThousandAtRandomInSimulatedTime) { send_a_hundred_thousand(true, false, 1); }
TEST(RandomCommands, AHundredThousandAtRandomInRealTimeBehindACoupling) { send_a_hundred_thousand(false, true, 2); }

}  // namespace
}  // namespace hapticut::random_commands_test
