// SPDX-License-Identifier: Apache-2.0
#include "hapticut/loop/realtime_loop.hpp"

#include <gtest/gtest.h>

#include <array>
#include <atomic>
#include <chrono>
#include <map>
#include <thread>

#include "hapticut/core/errors.hpp"
#include "hapticut/device/simulated/mock.hpp"

namespace hapticut::realtime_loop_test {
namespace {

/// The number that a block's content shows: how often it has been changed.
float& mark_of(ChangedBlock& block) { return block.fill[0]; }

/// A model that changes blocks in a pattern, and shows what it has done.
class ScribblingModel : public LoopModel {
 public:
  static constexpr int kEdge = 6;                      // blocks along each axis
  std::array<float, kEdge * kEdge * kEdge> changes{};  // of every block; the loop's own
  std::atomic<int> obeyed{0};
  double last_number = -1;
  bool in_order = true;
  long step_count = 0;

  Wrench step(const DeviceState& state, double dt, LoopSnapshot& snapshot) noexcept override {
    ++step_count;
    // All the same, or the reader saw half of it.
    snapshot.tool.force.setConstant(double(step_count));
    snapshot.tool.removed_volume = double(step_count);
    snapshot.tool.steps = std::uint64_t(step_count);
    snapshot.X_WT = state.X_BS;
    Wrench wrench;
    wrench.force.z() = state.X_BS.translation.z() < 0 ? 0.5 : 0;
    in_order = in_order && dt > 0;
    return wrench;
  }
  bool obey(LoopCommand& command) noexcept override {
    const auto* numbered = std::get_if<commands::SetScale>(&command);
    if (numbered == nullptr) return false;
    in_order = in_order && numbered->scale == last_number + 1;
    last_number = numbered->scale;
    ++obeyed;
    return true;
  }
  void mark_changes(BlockOutbox& outbox) noexcept override {
    for (int n = 0; n < 7; ++n) {  // more than a slow reader takes
      const int block = int((step_count * 31 + n * 17) % long(changes.size()));
      ++changes[std::size_t(block)];
      outbox.mark({8 * (block / (kEdge * kEdge)), 8 * (block / kEdge % kEdge), 8 * (block % kEdge)});
    }
  }
  void copy(ChangedBlock& block) noexcept override {
    const int n = (block.origin[0] * kEdge + block.origin[1]) * kEdge / 8 + block.origin[2] / 8;
    block.fill.fill(changes[std::size_t(n)]);
  }
};

RealtimeLoopOptions options_for(double seconds) {
  RealtimeLoopOptions options;
  options.run.seconds = seconds;
  options.run.simulated_time = true;
  options.run.stop_on_signals = false;
  constexpr int kLast = 8 * ScribblingModel::kEdge - 1;
  options.region = {{0, 0, 0}, {kLast, kLast, kLast}};
  options.block_capacity = 8;
  options.blocks_per_tick = 4;
  return options;
}

// 200 simulated seconds at full speed against a reader that looks 60 times a second, or as often as it can: no half
// snapshot, no command lost, no block lost for good. The sanitizers watch.
TEST(RealtimeLoop, ExchangesWithASlowReaderWithoutLosingABlockForGood) {
  const auto device = open_device("mock:spiral");
  ScribblingModel model;
  RealtimeLoop loop(*device, model, options_for(200));
  std::map<VoxelIndex, float> seen;
  std::uint64_t version = 0, tick = 0;
  double sent = 0;
  ChangedBlock block;
  const auto look = [&] {
    const LoopSnapshot& snapshot = loop.latest();
    EXPECT_GE(snapshot.tick, tick);
    tick = snapshot.tick;
    EXPECT_EQ(snapshot.tool.force, Vec3::Constant(double(snapshot.tool.steps)));
    EXPECT_EQ(snapshot.tool.removed_volume, double(snapshot.tool.steps));
    while (loop.receive(block)) {
      EXPECT_GT(block.version, version);
      version = block.version;
      for (const float value : block.fill) ASSERT_EQ(value, mark_of(block));
      EXPECT_GE(mark_of(block), seen[block.origin]);
      seen[block.origin] = mark_of(block);
    }
    if (loop.send(commands::SetScale{sent})) ++sent;
  };
  loop.start();
  while (loop.is_running()) {
    look();
    std::this_thread::sleep_for(std::chrono::milliseconds(16));
  }
  const RunReport report = loop.wait();
  EXPECT_EQ(report.ticks, 200001U);
  look();
  EXPECT_EQ(tick, 200001U);
  EXPECT_TRUE(model.in_order);
  EXPECT_GE(model.obeyed, 1);
  // The loop has ended with blocks that found no room: they are marked, and one more run with a reader sends them.
  EXPECT_GT(loop.latest().blocks_waiting, 0U);
}

TEST(RealtimeLoop, SendsTheLastVersionOfEveryBlockInTheEnd) {
  class QuietModel : public ScribblingModel {
    void mark_changes(BlockOutbox& outbox) noexcept override {
      if (step_count <= 2000) ScribblingModel::mark_changes(outbox);
    }
  };
  const auto device = open_device("mock:rest");
  QuietModel model;
  RealtimeLoop loop(*device, model, options_for(0));
  std::map<VoxelIndex, float> seen;
  ChangedBlock block;
  loop.start();
  // Until all has been sent for a while.
  for (int calm = 0; calm < 100;) {
    bool any = false;
    while (loop.receive(block)) {
      seen[block.origin] = mark_of(block);
      any = true;
    }
    const LoopSnapshot& snapshot = loop.latest();
    calm = !any && snapshot.tick > 2000 && snapshot.blocks_waiting == 0 ? calm + 1 : 0;
    std::this_thread::yield();
  }
  loop.stop();
  while (loop.receive(block)) seen[block.origin] = mark_of(block);
  ASSERT_EQ(seen.size(), model.changes.size());
  for (auto& [origin, value] : seen) {
    const int n = (origin[0] * ScribblingModel::kEdge + origin[1]) * ScribblingModel::kEdge / 8 + origin[2] / 8;
    EXPECT_EQ(value, model.changes[std::size_t(n)]);
  }
}

TEST(RealtimeLoop, TellsTheLargestForceOfTicksThatNobodyLookedAt) {
  class PushingModel : public ScribblingModel {
    Wrench step(const DeviceState& state, double dt, LoopSnapshot& snapshot) noexcept override {
      Wrench wrench = ScribblingModel::step(state, dt, snapshot);
      wrench.force.z() = step_count == 1500 ? 2 : 0;
      return wrench;
    }
  };
  const auto device = open_device("mock:rest");
  PushingModel model;
  RealtimeLoop loop(*device, model, options_for(2));
  loop.start();
  loop.wait();
  EXPECT_EQ(loop.latest().output.applied.force.norm(), 0);
  EXPECT_EQ(loop.latest().largest_commanded, 2);
  EXPECT_GT(loop.latest().largest_applied, 0);
  EXPECT_LT(loop.latest().largest_applied, 2) << "the guard lets a force grow slowly";
}

TEST(RealtimeLoop, CountsCommandsThatFindTheQueueFullAndLeavesThemAsTheyWere) {
  const auto device = open_device("mock:rest");
  ScribblingModel model;
  RealtimeLoop loop(*device, model, options_for(1));
  std::size_t taken = 0;
  for (int n = 0; n < 1000; ++n)
    if (loop.send(commands::SetScale{double(n)})) ++taken;
  EXPECT_EQ(taken, RealtimeLoop::kCommands);
  LoopCommand more = commands::SetTool(Tool(SphereHead{1e-3}), 1e-4, {});
  EXPECT_FALSE(loop.send(std::move(more)));
  EXPECT_FALSE(std::get<commands::SetTool>(more).tool.empty());
  loop.start();
  loop.wait();
  EXPECT_EQ(std::size_t(model.obeyed), taken);
  EXPECT_EQ(loop.latest().commands_dropped, 1001 - taken);
  EXPECT_EQ(loop.latest().commands_refused, 0U);
}

TEST(RealtimeLoop, CountsCommandsThatTheModelDoesNotKnow) {
  const auto device = open_device("mock:rest");
  ScribblingModel model;
  RealtimeLoop loop(*device, model, options_for(0.1));
  loop.send(commands::Undo{});
  loop.send(commands::SetScale{0});
  loop.send(commands::Redo{});
  loop.start();
  loop.wait();
  EXPECT_EQ(loop.latest().commands_refused, 2U);
  EXPECT_EQ(model.obeyed, 1);
}

TEST(RealtimeLoop, HandsBackWhatWasReplacedHoweverMuchThereIs) {
  class SwappingModel : public ScribblingModel {
   public:
    explicit SwappingModel(PreparedTool tool) : in_place(std::move(tool)) {}
    bool obey(LoopCommand& command) noexcept override {
      std::swap(in_place, std::get<commands::SetTool>(command).tool);
      loop_thread = std::this_thread::get_id();
      ++obeyed;
      return true;
    }
    PreparedTool in_place;
    std::thread::id loop_thread;
  };
  const auto device = open_device("mock:rest");
  SwappingModel model(PreparedTool(Tool(SphereHead{1e-3}), 1e-4, {}));
  RealtimeLoop loop(*device, model, options_for(0));
  loop.start();
  // More tools than there are places, each of another size: the last one is in place in the end.
  constexpr int kTools = 300;
  double radius = 1e-3;
  for (int n = 0; n < kTools; ++n) {
    LoopCommand next = commands::SetTool(Tool(SphereHead{radius += 1e-7}), 1e-4, {});
    while (!loop.send(std::move(next))) std::this_thread::yield();
  }
  while (model.obeyed < kTools) std::this_thread::yield();
  loop.stop();
  EXPECT_NE(model.loop_thread, std::this_thread::get_id());
  EXPECT_EQ(std::get<SphereHead>(model.in_place.tool().head().shape()).radius, radius);
}

TEST(RealtimeLoop, StopsByRequestByCallAndWhenItGoesAway) {
  const auto device = open_device("mock:circle");
  ScribblingModel model;
  {
    RealtimeLoop loop(*device, model, options_for(0));
    loop.start();
    EXPECT_THROW(loop.start(), Error);
    while (loop.latest().tick == 0) std::this_thread::yield();
    loop.requests().stop();
    EXPECT_GT(loop.wait().ticks, 0U);
    EXPECT_THROW((void)loop.wait(), Error);
    loop.start();
    loop.stop();
    loop.start();
  }
  EXPECT_FALSE(device->is_running());
}

TEST(RealtimeLoop, HasTheMailboxOfItsDevice) {
  const auto device = open_device("mock:rest");
  ScribblingModel model;
  RealtimeLoop loop(*device, model, options_for(0));
  EXPECT_EQ(&loop.requests(), &device->requests());
  loop.start();
  loop.requests().emergency_stop();
  while (loop.latest().arming != ArmingState::fault) std::this_thread::yield();
  loop.requests().reset_fault();
  while (loop.latest().arming == ArmingState::fault) std::this_thread::yield();
  EXPECT_GE(loop.stop().events[std::size_t(SafetyEvent::emergency_stop)], 1U);
}

TEST(BlockOutbox, RefusesRegionsThatItCannotHold) {
  EXPECT_THROW(BlockOutbox(IndexBox{}, 8), Error);
  EXPECT_THROW(BlockOutbox(IndexBox{{0, 0, 0}, {99999, 99999, 99999}}, 8), Error);
  BlockOutbox outbox(IndexBox{{-9, 0, 0}, {7, 7, 7}}, 2);
  EXPECT_TRUE(outbox.mark({-16, 0, 0}));
  EXPECT_TRUE(outbox.mark({0, 0, 0}));
  EXPECT_TRUE(outbox.mark({0, 0, 0}));
  EXPECT_EQ(outbox.marked(), 2U);
  EXPECT_FALSE(outbox.mark({8, 0, 0}));
  EXPECT_FALSE(outbox.mark({-24, 0, 0}));
  EXPECT_EQ(outbox.outside(), 2U);
}

}  // namespace
}  // namespace hapticut::realtime_loop_test
