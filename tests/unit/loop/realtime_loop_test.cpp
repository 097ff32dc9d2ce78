// SPDX-License-Identifier: Apache-2.0
#include "hapticut/loop/realtime_loop.hpp"

#include <gtest/gtest.h>

#include <atomic>
#include <chrono>
#include <set>
#include <thread>
#include <utility>
#include <vector>

#include "experiments/setup/cutting.hpp"
#include "hapticut/core/errors.hpp"
#include "hapticut/device/simulated/mock.hpp"
#include "hapticut/simulation/simulation.hpp"
#include "hapticut/workpiece/builders.hpp"

namespace hapticut::realtime_loop_test {
namespace {

/// A model that publishes its number of steps.
class CountingModel : public LoopModel {
 public:
  std::atomic<int> applied{0};
  double last_number = -1;
  bool in_order = true;
  long step_count = 0;

  Wrench step(const DeviceState& state, double dt, LoopSnapshot& snapshot) noexcept override {
    ++step_count;
    // All values are equal in a complete snapshot.
    snapshot.tool.force.setConstant(double(step_count));
    snapshot.tool.removed_volume = double(step_count);
    snapshot.tool.steps = std::uint64_t(step_count);
    snapshot.X_WT = state.X_BS;
    Wrench wrench;
    wrench.force.z() = state.X_BS.translation.z() < 0 ? 0.5 : 0;
    in_order = in_order && dt > 0;
    return wrench;
  }
  bool apply(LoopCommand& command) noexcept override {
    const auto* numbered = std::get_if<commands::SetScale>(&command);
    if (numbered == nullptr) return false;
    in_order = in_order && numbered->scale == last_number + 1;
    last_number = numbered->scale;
    ++applied;
    return true;
  }
};

RealtimeLoopOptions options_for(double seconds) {
  RealtimeLoopOptions options;
  options.run.seconds = seconds;
  options.run.simulated_time = true;
  options.run.stop_on_signals = false;
  return options;
}

// 200 simulated seconds at full speed with a reader that polls 60 times a second: no partial snapshot, no command lost.
// Also run with the sanitizers.
TEST(RealtimeLoop, GivesASlowReaderWholeSnapshotsAndAppliesCommandsInOrder) {
  const auto device = open_device("mock:spiral");
  CountingModel model;
  RealtimeLoop loop(*device, model, options_for(200));
  std::uint64_t tick = 0;
  double sent = 0;
  const auto look = [&] {
    const LoopSnapshot& snapshot = loop.latest();
    EXPECT_GE(snapshot.tick, tick);
    tick = snapshot.tick;
    EXPECT_EQ(snapshot.tool.force, Vec3::Constant(double(snapshot.tool.steps)));
    EXPECT_EQ(snapshot.tool.removed_volume, double(snapshot.tool.steps));
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
  EXPECT_GE(model.applied, 1);
}

TEST(RealtimeLoop, ReportsTheMaximumForceOfUnreadTicks) {
  class PushingModel : public CountingModel {
    Wrench step(const DeviceState& state, double dt, LoopSnapshot& snapshot) noexcept override {
      Wrench wrench = CountingModel::step(state, dt, snapshot);
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
  EXPECT_EQ(loop.latest().max_commanded, 2);
  EXPECT_GT(loop.latest().max_applied, 0);
  EXPECT_LT(loop.latest().max_applied, 2) << "the guard lets a force grow slowly";
}

TEST(RealtimeLoop, CountsCommandsForAFullQueueAndLeavesThemUnchanged) {
  const auto device = open_device("mock:rest");
  CountingModel model;
  RealtimeLoop loop(*device, model, options_for(1));
  std::size_t accepted = 0;
  for (int n = 0; n < 1000; ++n)
    if (loop.send(commands::SetScale{double(n)})) ++accepted;
  EXPECT_EQ(accepted, RealtimeLoop::kCommands);
  LoopCommand more = commands::SetTool(Tool(SphereHead{1e-3}), 1e-4, {});
  EXPECT_FALSE(loop.send(std::move(more)));
  EXPECT_FALSE(std::get<commands::SetTool>(more).tool.empty());
  loop.start();
  loop.wait();
  EXPECT_EQ(std::size_t(model.applied), accepted);
  EXPECT_EQ(loop.latest().commands_dropped, 1001 - accepted);
  EXPECT_EQ(loop.latest().commands_refused, 0U);
}

TEST(RealtimeLoop, CountsCommandsThatTheModelDoesNotKnow) {
  const auto device = open_device("mock:rest");
  CountingModel model;
  RealtimeLoop loop(*device, model, options_for(0.1));
  loop.send(commands::Undo{});
  loop.send(commands::SetScale{0});
  loop.send(commands::Redo{});
  loop.start();
  loop.wait();
  EXPECT_EQ(loop.latest().commands_refused, 2U);
  EXPECT_EQ(model.applied, 1);
}

TEST(RealtimeLoop, ReturnsEveryReplacedObject) {
  class SwappingModel : public CountingModel {
   public:
    explicit SwappingModel(PreparedTool tool) : in_place(std::move(tool)) {}
    bool apply(LoopCommand& command) noexcept override {
      std::swap(in_place, std::get<commands::SetTool>(command).tool);
      loop_thread = std::this_thread::get_id();
      ++applied;
      return true;
    }
    PreparedTool in_place;
    std::thread::id loop_thread;
  };
  const auto device = open_device("mock:rest");
  SwappingModel model(PreparedTool(Tool(SphereHead{1e-3}), 1e-4, {}));
  RealtimeLoop loop(*device, model, options_for(0));
  loop.start();
  // More tools than the queue has places, each of another size. In the end the last one is in place.
  constexpr int kTools = 300;
  double radius = 1e-3;
  for (int n = 0; n < kTools; ++n) {
    LoopCommand next = commands::SetTool(Tool(SphereHead{radius += 1e-7}), 1e-4, {});
    while (!loop.send(std::move(next))) std::this_thread::yield();
  }
  while (model.applied < kTools) std::this_thread::yield();
  loop.stop();
  EXPECT_NE(model.loop_thread, std::this_thread::get_id());
  EXPECT_EQ(std::get<SphereHead>(model.in_place.tool().head().shape()).radius, radius);
}

TEST(RealtimeLoop, StopsOnRequestOnCallAndOnDestruction) {
  const auto device = open_device("mock:circle");
  CountingModel model;
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
  CountingModel model;
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
  constexpr int kFar = 1 << 30;
  EXPECT_THROW(BlockOutbox(IndexBox{{-kFar, -kFar, -kFar}, {kFar, kFar, kFar}}, 8), Error);
  BlockOutbox outbox(IndexBox{{-9, 0, 0}, {7, 7, 7}}, 2);
  EXPECT_TRUE(outbox.mark({-16, 0, 0}));
  EXPECT_TRUE(outbox.mark({0, 0, 0}));
  EXPECT_TRUE(outbox.mark({0, 0, 0}));
  EXPECT_EQ(outbox.marked(), 2U);
  EXPECT_FALSE(outbox.mark({8, 0, 0}));
  EXPECT_FALSE(outbox.mark({-24, 0, 0}));
  EXPECT_EQ(outbox.outside(), 2U);
}

Simulation block_and_ball(double size = 8e-3) {
  SimulationConfig config;
  config.reserved_blocks = 200;
  return Simulation(build_block({Vec3::Constant(-size / 2), Vec3::Constant(size / 2)}, 2e-4, test::plain_material()),
                    Tool(SphereHead{1e-3}), config);
}

/// One voxel of the n-th block. Five blocks lie in a row along z; the rows follow each other along x.
BlockVoxels voxel_of_block(int n) {
  BlockVoxels one{{8 * (n / 5), 0, 8 * (n % 5)}, {}};
  one.voxels.add(7);
  return one;
}

/// A model whose step removes a voxel of each of some blocks from a simulation.
class RemovingModel : public LoopModel {
 public:
  explicit RemovingModel(Simulation& simulation) : simulation_(simulation) {}
  Wrench step(const DeviceState& /*state*/, double /*dt*/, LoopSnapshot& /*snapshot*/) noexcept override {
    for (; to_remove > 0; --to_remove) (void)simulation_.remove_voxels(voxel_of_block(to_remove));
    return {};
  }
  [[nodiscard]] Simulation* simulation() noexcept override { return &simulation_; }
  int to_remove = 0;

 private:
  Simulation& simulation_;
};

std::set<VoxelIndex> received(RealtimeLoop& loop) {
  std::set<VoxelIndex> origins;
  std::uint64_t version = 0;
  for (ChangedBlock block; loop.receive(block);) {
    EXPECT_GT(block.version, std::exchange(version, block.version));
    origins.insert(block.origin);
  }
  return origins;
}

TEST(RealtimeLoop, SendsAllChangedBlocksAfterItsEndWithAQueueOfAnySize) {
  Simulation simulation = block_and_ball();
  const auto device = open_device("mock:rest");
  RemovingModel model(simulation);
  RealtimeLoopOptions options = options_for(0.01);
  options.region = simulation.workpiece().bounds();
  options.block_capacity = 2;
  RealtimeLoop loop(*device, model, options);
  model.to_remove = 20;
  loop.start();
  (void)loop.wait();
  ChangedBlock first;
  ASSERT_TRUE(loop.receive(first));
  EXPECT_EQ(received(loop).size(), 19U);
  // The next run sends blocks that were not received once more, with higher versions.
  model.to_remove = 24;
  loop.start();
  (void)loop.wait();
  ASSERT_TRUE(loop.receive(first));
  loop.start();
  (void)loop.wait();
  EXPECT_EQ(received(loop).size(), 3U);
}

TEST(RealtimeLoop, SendsTheChangesBetweenTwoRuns) {
  Simulation simulation = block_and_ball();
  const auto device = open_device("mock:rest");
  RemovingModel model(simulation);
  RealtimeLoopOptions options = options_for(0.01);
  options.region = simulation.workpiece().bounds();
  RealtimeLoop loop(*device, model, options);
  const auto run = [&] {
    loop.start();
    (void)loop.wait();
    return received(loop);
  };
  EXPECT_TRUE(run().empty());
  EXPECT_TRUE(run().empty()) << "nothing has changed";
  ASSERT_TRUE(simulation.remove_voxels(voxel_of_block(3)));
  EXPECT_TRUE(run().contains(voxel_of_block(3).origin));
  simulation.reset(simulation.workpiece().clone());
  EXPECT_GT(run().size(), 100U);
  simulation.step({}, {}, 1e-3);
  EXPECT_GT(run().size(), 100U);
  EXPECT_TRUE(run().empty());
}

TEST(ChangeFeed, SendsAllOfAnotherWorkpieceAlsoDuringASteadyCut) {
  Simulation simulation = block_and_ball();
  for (const std::size_t per_tick : {1U, 2U, 5U}) {
    ChangeFeed feed(simulation, simulation.workpiece().bounds(), 100);
    feed.send_all();
    const std::size_t all = feed.waiting();
    std::set<VoxelIndex> origins;
    std::size_t changes = 0;
    for (std::size_t tick = 0; tick < 2 * all + 2; ++tick) {
      for (int n = 0; n < 10; ++n) feed.mark(voxel_of_block(n).origin);
      feed.tick(per_tick, 0);
      for (ChangedBlock block; feed.receive(block);) changes += origins.insert(block.origin).second ? 0 : 1;
    }
    EXPECT_EQ(origins.size(), all) << per_tick;
    EXPECT_GE(changes, all * per_tick / 2) << "changed blocks are sent meanwhile";
  }
}

TEST(ChangeFeed, CountsTheBlocksOfALargerWorkpieceOutsideItsRegion) {
  Simulation simulation = block_and_ball(), larger = block_and_ball(16e-3);
  ChangeFeed feed(simulation);
  simulation.exchange(larger);
  EXPECT_EQ(feed.outside(), 10U * 10 * 10 - 5U * 5 * 5);
}

TEST(ChangeFeed, NumbersTheWorkpiecesOfASimulation) {
  Simulation simulation = block_and_ball();
  ChangeFeed feed(simulation, {1000, 1000});
  ChangedBlock block;
  ASSERT_TRUE(simulation.remove_voxels(voxel_of_block(1)));
  simulation.step(Pose::from_translation({0, 0, 1}), {}, 1e-3);
  ASSERT_TRUE(feed.receive(block));
  EXPECT_EQ(block.workpiece, 0U);
  simulation.reset(simulation.workpiece().clone());
  simulation.step(Pose::from_translation({0, 0, 1}), {}, 1e-3);
  ASSERT_TRUE(feed.receive(block));
  EXPECT_EQ(block.workpiece, 1U);
}

TEST(ChangeFeed, AcceptsAWorkpieceThatIsEmptied) {
  Simulation simulation = block_and_ball();
  simulation.reserve_blocks(1000);
  for_each_block_origin(simulation.workpiece().bounds(), [&](const VoxelIndex& origin) {
    ASSERT_TRUE(simulation.remove_voxels({origin, BlockMask::all()}));
  });
  ASSERT_TRUE(simulation.workpiece().empty());
  ChangeFeed feed(simulation);
  EXPECT_EQ(feed.outside(), 0U);
}

TEST(ChangeFeed, SendsTheChangesOfAnUndoAndAllOfAnotherWorkpiece) {
  const auto make = [] {
    return Simulation(build_block({Vec3::Constant(-4e-3), Vec3::Constant(4e-3)}, 2e-4, test::plain_material()),
                      Tool(SphereHead{1e-3}), {});
  };
  Simulation simulation = make(), other = make();
  simulation.reserve_blocks(10);
  other.reserve_blocks(10);
  simulation.history().reserve(10);
  ASSERT_TRUE(simulation.history().mark());
  constexpr std::uint32_t kNumber = 3;
  ChangeFeed feed(simulation);
  const auto origins_received = [&] {
    std::vector<VoxelIndex> origins;
    for (ChangedBlock block; feed.receive(block);) {
      EXPECT_EQ(block.workpiece, kNumber);
      origins.push_back(block.origin);
    }
    return origins;
  };
  BlockVoxels some{{8, 0, 0}, {}};
  some.voxels.add(7);
  ASSERT_TRUE(simulation.remove_voxels(some));
  feed.tick(16, kNumber);
  EXPECT_EQ(origins_received(), std::vector{some.origin});
  ASSERT_TRUE(simulation.history().undo(16));
  feed.tick(16, kNumber);
  EXPECT_EQ(origins_received(), std::vector{some.origin});
  feed.tick(16, kNumber);
  EXPECT_TRUE(origins_received().empty());
  simulation.exchange(other);
  const std::size_t all = feed.waiting();
  EXPECT_GT(all, 100U);
  ASSERT_TRUE(simulation.remove_voxels(some));
  feed.tick(16, kNumber);
  std::vector<VoxelIndex> origins = origins_received();
  ASSERT_EQ(origins.size(), 16U);
  EXPECT_EQ(origins.front(), some.origin) << "changed blocks come before the others";
  while (feed.waiting() > 0) {
    feed.tick(16, kNumber);
    for (const VoxelIndex& origin : origins_received()) origins.push_back(origin);
  }
  EXPECT_GE(origins.size(), all);
}

}  // namespace
}  // namespace hapticut::realtime_loop_test
