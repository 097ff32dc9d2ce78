// SPDX-License-Identifier: Apache-2.0
// The removal of a piece that a tool has cut loose: in a simulation, in a custom loop, and in the loop of a model.
#include "hapticut/islands/island_watch.hpp"

#include <gtest/gtest.h>

#include <chrono>
#include <cmath>
#include <numeric>
#include <optional>
#include <thread>

#include "support/refusal.hpp"
#include "support/scripted_loop.hpp"

namespace hapticut::island_watch_test {
namespace {

using units::mm;

constexpr double kVoxel = 0.1 * mm, kCut = 4 * mm, kRadius = 0.6 * mm;

/// A bar of 0.8 mm x 0.8 mm x 6 mm, and a ball that cuts through it at a height of 4 mm.
Simulation bar_and_ball() {
  Workpiece bar = build_block({Vec3(-0.4, -0.4, 0) * mm, Vec3(0.4, 0.4, 6) * mm}, kVoxel, test::plain_material());
  SimulationConfig config;
  config.reserved_blocks = 500;
  return Simulation(std::move(bar), Tool(SphereHead{kRadius}, RayHandle{0}, Spindle{3000 * units::rad_per_s}), config);
}

constexpr int kThrough = 800;
void cut_through(Simulation& simulation, int tick) {
  const double speed = 4 * mm, x = -2 * mm + speed * 1e-3 * tick;
  (void)simulation.step(Pose::from_translation({x, 0.013 * mm, kCut}), {{speed, 0, 0}, Vec3::Zero()}, 1e-3);
}

double sum(const ByMaterial<double>& volumes) { return std::accumulate(volumes.begin(), volumes.end(), 0.0); }

double volume_of(const Workpiece& workpiece) {
  double volume = 0;
  for (const MaterialAmount& amount : workpiece.amounts()) volume += amount.volume;
  return volume;
}

TEST(RemoveIsland, TakesAPieceOutThatIsBookedAsNotCutAndUndoBringsItBack) {
  Simulation simulation = bar_and_ball();
  simulation.history().reserve(500);
  simulation.history().mark();
  const double whole = volume_of(simulation.workpiece());
  const std::uint64_t hash = simulation.workpiece().hash();
  IslandFinder finder(simulation.workpiece());
  std::vector<Island> islands;
  for (int tick = 1; tick <= kThrough && islands.empty(); ++tick) {
    cut_through(simulation, tick);
    finder.update(simulation.workpiece(), simulation.changed_blocks().origins);
    islands = finder.find();
  }
  ASSERT_EQ(islands.size(), 1U);
  EXPECT_NEAR(double(islands[0].voxels), 8 * 8 * 15, 60) << "from 4.6 mm to 6 mm, and the dome that the ball leaves";
  const double cut = sum(simulation.totals().removed_volume), cutting = simulation.last_result().energy.cutting;
  IslandRemoval removal{islands[0]};
  int slices = 0;
  while (!remove_island(simulation, removal, 2)) ++slices;
  EXPECT_FALSE(removal.joined);
  EXPECT_GE(slices, 2);
  EXPECT_FALSE(simulation.changed_blocks().origins.empty());
  EXPECT_TRUE(find_islands(simulation.workpiece()).empty());
  const double left = sum(simulation.totals().detached_volume);
  EXPECT_NEAR(left, double(islands[0].voxels) * std::pow(kVoxel, 3), 0.05 * left);
  EXPECT_EQ(sum(simulation.totals().removed_volume), cut);
  EXPECT_EQ(simulation.last_result().energy.cutting, cutting);
  EXPECT_NEAR(volume_of(simulation.workpiece()) + cut + left, whole, 1e-9 * whole);
  for (int z = 46; z < 60; ++z) EXPECT_EQ(simulation.workpiece().material_at({4, 4, z}), kEmpty) << z;
  // The tool continues, and the ledger closes.
  for (int tick = kThrough; tick < kThrough + 50; ++tick) cut_through(simulation, tick);
  EXPECT_LT(std::abs(simulation.last_result().energy.closure()), 1e-3);
  while (!simulation.history().undo(64)) {
  }
  EXPECT_EQ(simulation.workpiece().hash(), hash);
}

TEST(RemoveIsland, LeavesAPieceThatAnUndoHasJoinedAgain) {
  Simulation simulation = bar_and_ball();
  simulation.history().reserve(500);
  simulation.history().mark();
  for (int tick = 1; tick <= kThrough; ++tick) cut_through(simulation, tick);
  const std::vector<Island> islands = find_islands(simulation.workpiece());
  ASSERT_EQ(islands.size(), 1U);
  IslandRemoval half{islands[0]}, late{islands[0]};
  EXPECT_FALSE(remove_island(simulation, half, islands[0].blocks.size() + 1))
      << "all blocks were checked, one was removed";
  EXPECT_GT(half.removed, 0U);
  while (!simulation.history().undo(64)) {
  }
  const std::uint64_t hash = simulation.workpiece().hash();
  EXPECT_TRUE(remove_island(simulation, half, 64));
  EXPECT_TRUE(half.joined);
  EXPECT_TRUE(remove_island(simulation, late, 64));
  EXPECT_TRUE(late.joined);
  EXPECT_EQ(simulation.workpiece().hash(), hash);
}

TEST(RemoveIsland, WaitsWhereNoReservedBlockIsLeft) {
  Material bone = test::plain_material();
  SimulationConfig config;
  config.reserved_blocks = 1;
  Simulation simulation(build_block({Vec3::Zero(), Vec3::Constant(1.6 * mm)}, kVoxel, bone), Tool(SphereHead{kRadius}),
                        config);
  BlockVoxels some;
  some.voxels.words[3] = 0xff;
  BlockVoxels others = some;
  others.origin = {8, 8, 8};
  EXPECT_TRUE(simulation.remove_voxels(some));
  EXPECT_FALSE(simulation.remove_voxels(others));
  EXPECT_NEAR(sum(simulation.totals().detached_volume), 8 * std::pow(kVoxel, 3), 1e-20);
  simulation.reserve_blocks(4);
  EXPECT_TRUE(simulation.remove_voxels(others));
}

TEST(IslandWatch, RemovesAPieceBesideACustomLoop) {
  Simulation simulation = bar_and_ball();
  IslandWatch watch(simulation);
  for (int tick = 1; tick <= kThrough; ++tick) {
    cut_through(simulation, tick);
    watch.tick();
  }
  while (watch.count() == 0) {  // goes on in the air until the thread of the watch has run
    cut_through(simulation, kThrough + 10);
    watch.tick();
    std::this_thread::yield();
  }
  EXPECT_EQ(watch.count(), 1U);
  EXPECT_TRUE(find_islands(simulation.workpiece()).empty());
  EXPECT_GT(sum(simulation.totals().detached_volume), 0);
  std::vector<Island> left;
  while (left.empty()) {
    left = watch.removed();
    std::this_thread::yield();
  }
  ASSERT_EQ(left.size(), 1U);
  EXPECT_GT(left[0].voxels, 800);
}

/// A bar along z, of 8 x 8 voxels.
/// @param from, to  [mm]
Workpiece bar(double from, double to) {
  Workpiece bar = build_block({Vec3(-0.4, -0.4, from) * mm, Vec3(0.4, 0.4, to) * mm}, kVoxel, test::plain_material());
  bar.reserve_blocks(100);
  return bar;
}

constexpr int kInLayer = 64;
BlockVoxels layer(int k) {
  BlockVoxels voxels{{0, 0, block_start(k)}, {}};
  for (int x = 0; x < 8; ++x)
    for (int y = 0; y < 8; ++y) voxels.voxels.add(block_offset(x, y, k - block_start(k)));
  return voxels;
}

IslandWatchOptions quick_watch() {
  IslandWatchOptions options;
  options.period = 1e-3;
  return options;
}

/// Steps in the air.
void wait(Simulation& simulation, IslandWatch& watch, int ticks) {
  for (int n = 0; n < ticks; ++n) {
    simulation.step(Pose::from_translation({0, 0, 20 * mm}), {}, 1e-3);
    watch.tick();
    std::this_thread::yield();
  }
}

/// Cuts a layer out and waits until the watch removes the loose piece. If the watch had not seen the whole workpiece
/// before the cut, the function undoes the cut and repeats it.
void cut_layer(Simulation& simulation, IslandWatch& watch, int k) {
  const std::uint64_t before = watch.count();
  for (;;) {
    simulation.history().mark();
    ASSERT_TRUE(simulation.remove_voxels(layer(k)));
    wait(simulation, watch, 200);
    if (watch.count() > before) break;
    while (!simulation.history().undo(64)) {
    }
    wait(simulation, watch, 200);
  }
}

TEST(IslandWatch, LeavesTheBodiesOfAnotherWorkpieceAndWatchesThem) {
  for (const bool exchanged : {false, true}) {
    Simulation simulation = bar_and_ball();
    simulation.history().reserve(100);
    IslandWatch watch(simulation, quick_watch());
    wait(simulation, watch, 20);
    Workpiece two = bar(0, 6);
    ASSERT_NE(two.writable_fill({0, 0, 16}), nullptr);
    two.empty_voxels({0, 0, 16}, layer(20).voxels);  // two bodies, of 20 and 39 layers
    if (exchanged) {
      Simulation other(std::move(two), simulation.tool(), simulation.config());
      other.history().reserve(100);
      simulation.exchange(other);
    } else {
      simulation.reset(std::move(two));
    }
    wait(simulation, watch, 1000);
    EXPECT_EQ(simulation.workpiece().solid_voxels(), 59 * kInLayer);
    cut_layer(simulation, watch, 50);
    EXPECT_EQ(watch.count(), 1U);
    EXPECT_EQ(simulation.workpiece().solid_voxels(), 49 * kInLayer) << "only the part beyond the cut was removed";
  }
}

TEST(IslandWatch, FollowsTheFrameAndTheBoundsOfAnotherWorkpiece) {
  IslandWatchOptions options = quick_watch();
  options.islands.fixed = Box{Vec3(-1, -1, -3) * mm, Vec3(1, 1, 0.5) * mm};
  Simulation simulation = bar_and_ball();
  simulation.history().reserve(200);
  IslandWatch watch(simulation, options);
  simulation.reset(bar(-3, 9));
  cut_layer(simulation, watch, 40);  // 1 mm above the origin; the part above the cut is the longer one
  EXPECT_EQ(watch.count(), 1U);
  EXPECT_EQ(simulation.workpiece().solid_voxels(), 40 * kInLayer);
}

/// Two bodies of some voxels, so far apart that the box around them has 324^3 blocks, more than a search can hold. The
/// box begins and ends within a block: 2^34 voxels, the maximum of a workpiece, would fit if they were whole blocks.
Workpiece far_apart() {
  constexpr int kFar = 323 * kBlockEdge;
  const VoxelIndex first = {0, 0, 0}, last = {kFar, kFar, kFar};
  return Workpiece::from_blocks({{7, 7, 7}, {kFar + 1, kFar + 1, kFar + 1}}, GridFrame{kVoxel, Pose{}},
                                MaterialTable({test::plain_material()}),
                                [&](const VoxelIndex& origin, BlockContent& /*content*/) {
                                  return origin == first || origin == last ? BlockKind::solid(1) : BlockKind::empty();
                                });
}

TEST(IslandWatch, SaysWhyItDoesNotWatchAWorkpieceAndWatchesTheNext) {
  Simulation simulation = bar_and_ball();
  IslandWatch watch(simulation, quick_watch());
  EXPECT_EQ(watch.fault(), std::nullopt);
  simulation.reset(far_apart());
  while (!watch.fault()) wait(simulation, watch, 1);
  test::expect_part(watch.fault().value_or(""), "blocks, more than 3.35544e+07 in which islands can be found");
  simulation.reset(bar(0, 6));
  while (watch.fault()) wait(simulation, watch, 1);
  simulation.history().reserve(200);
  cut_layer(simulation, watch, 40);
  EXPECT_EQ(watch.count(), 1U);
  EXPECT_EQ(watch.fault(), std::nullopt);
}

TEST(IslandWatch, RemovesALoosePieceAgainThatAnUndoBringsBack) {
  Simulation simulation = bar_and_ball();
  simulation.history().reserve(200);
  IslandWatch watch(simulation, quick_watch());
  ASSERT_TRUE(simulation.remove_voxels(layer(40)));
  simulation.history().mark();
  while (watch.count() == 0) wait(simulation, watch, 1);
  EXPECT_EQ(simulation.workpiece().solid_voxels(), 40 * kInLayer);
  while (!simulation.history().undo(64)) {
  }
  EXPECT_EQ(simulation.workpiece().solid_voxels(), 59 * kInLayer);
  while (watch.count() == 1) wait(simulation, watch, 1);
  EXPECT_EQ(simulation.workpiece().solid_voxels(), 40 * kInLayer);
}

// The blocks arrive one by one, so the search first sees parts of the piece, which stay because they touch the rest.
TEST(IslandWatch, RemovesAPieceWhosePartsItSawAtDifferentTimes) {
  IslandWatchOptions options;
  options.period = 1e-4;
  options.blocks.blocks_per_step = 1;
  Simulation simulation = bar_and_ball();
  simulation.history().reserve(200);
  IslandWatch watch(simulation, options);
  const auto wait_slowly = [&](int ticks) {
    for (int n = 0; n < ticks; ++n) {
      wait(simulation, watch, 1);
      std::this_thread::sleep_for(std::chrono::milliseconds(1));
    }
  };
  wait_slowly(20);
  simulation.history().mark();
  ASSERT_TRUE(simulation.remove_voxels(layer(30)));
  wait_slowly(100);
  ASSERT_EQ(watch.count(), 1U);
  while (!simulation.history().undo(64)) {
  }
  ASSERT_TRUE(simulation.remove_voxels(layer(30)));
  wait_slowly(300);
  EXPECT_EQ(watch.count(), 2U);
  EXPECT_EQ(simulation.workpiece().solid_voxels(), 30 * kInLayer);
}

// Two blocks change in each tick and the feed sends one, so changed blocks always wait.
TEST(IslandWatch, RemovesAPieceWhileMoreChangesThanTheFeedSends) {
  IslandWatchOptions options;
  options.period = 1e-4;
  options.blocks.blocks_per_step = 1;
  Simulation simulation = bar_and_ball();
  simulation.history().reserve(200);
  IslandWatch watch(simulation, options);
  const auto tick = [&] {
    wait(simulation, watch, 1);
    std::this_thread::sleep_for(std::chrono::milliseconds(1));
  };
  for (int n = 0; n < 20; ++n) tick();
  simulation.history().mark();
  ASSERT_TRUE(simulation.remove_voxels(layer(10)));
  for (int n = 0; n < 100; ++n) tick();
  ASSERT_EQ(watch.count(), 1U);
  while (!simulation.history().undo(64)) {
  }
  ASSERT_TRUE(simulation.remove_voxels(layer(10)));
  for (int n = 0; n < 200; ++n) {
    for (const int z : {40, 48}) {
      BlockVoxels voxel{{0, 0, z}, {}};
      voxel.voxels.add(n);
      ASSERT_TRUE(simulation.remove_voxels(voxel));
    }
    tick();
  }
  EXPECT_EQ(watch.count(), 2U);
  EXPECT_TRUE(find_islands(simulation.workpiece()).empty());
}

TEST(IslandWatch, AcceptsAWorkpieceThatIsEmptied) {
  Simulation simulation = bar_and_ball();
  for (int k = 0; k < 60; ++k) ASSERT_TRUE(simulation.remove_voxels(layer(k)));
  ASSERT_TRUE(simulation.workpiece().empty());
  IslandWatch watch(simulation);
  wait(simulation, watch, 10);
  EXPECT_EQ(watch.count(), 0U);
}

TEST(IslandModel, NeedsAModelOfASimulation) {
  struct : LoopModel {
    Wrench step(const DeviceState& /*state*/, double /*dt*/, LoopSnapshot& /*snapshot*/) noexcept override {
      return {};
    }
  } of_nothing;
  test::expect_refused([&] { IslandModel model(of_nothing); },
                       {"drives no simulation", "whose simulation() is not null"});
}

TEST(IslandModel, RemovesIslandsAndSendsTheirBlocks) {
  using namespace test::scripted_loop;
  // A piece away from the hand is cut loose between two ticks, so it is the same in every run.
  Simulation simulation(block(), ball(), config());
  const std::unique_ptr<Device> device = stiff_mock("rest");
  SimulationModel without(simulation, *device);
  IslandWatchOptions options;
  options.period = 1e-3;
  IslandModel model(without, options);
  LoopSnapshot snapshot;
  // Removes the voxels around a cube of 20 voxels, at 20 ... 39 along x and y and 12 ... 31 along z.
  for (int x = 16; x < 48; x += 8)
    for (int y = 16; y < 48; y += 8)
      for (int z = 8; z < 40; z += 8) {
        BlockVoxels around{{x, y, z}, {}};
        for (int n = 0; n < kBlockVoxels; ++n) {
          const VoxelIndex at = voxel_at({x, y, z}, n);
          const auto in_cube = [&](int from, int a) { return a >= from && a <= 39; };
          if (!(in_cube(20, at[0]) && in_cube(20, at[1]) && at[2] >= 12 && at[2] <= 31)) around.voxels.add(n);
        }
        ASSERT_TRUE(simulation.remove_voxels(around));
      }
  const double cut_out = sum(simulation.totals().detached_volume);
  ChangeFeed feed(simulation, without.region(), 10000);
  feed.attach();
  (void)device->run(
      [&](const DeviceState& reading) {
        DeviceState far = reading;
        far.X_BS.translation = Vec3(0, 0, 20 * mm);
        DeviceCommand command{model.step(far, 1e-3, snapshot), false};
        command.stop = model.watch().count() > 0;
        std::this_thread::yield();
        return command;
      },
      simulated_run());
  EXPECT_EQ(model.watch().count(), 1U);
  EXPECT_GE(feed.waiting(), 27U);
  EXPECT_NEAR(sum(simulation.totals().detached_volume) - cut_out, 8000 * std::pow(0.2 * mm, 3), 1e-18);
  EXPECT_EQ(snapshot.tool.removed_volume, 0);
  std::vector<Island> left;
  while (left.empty()) {
    left = model.watch().removed();
    std::this_thread::yield();
  }
  ASSERT_EQ(left.size(), 1U);
  EXPECT_EQ(left[0].voxels, 8000);
}

}  // namespace
}  // namespace hapticut::island_watch_test
