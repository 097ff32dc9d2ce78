// SPDX-License-Identifier: Apache-2.0
// The changed blocks of a step, compared with every voxel of the workpiece before
// and after it.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <map>
#include <set>

#include "experiments/setup/cutting.hpp"
#include "hapticut/core/units.hpp"
#include "support/scenes.hpp"

namespace hapticut::changed_blocks_test {
namespace {

using Fills = std::array<float, kBlockVoxels>;

std::map<VoxelIndex, Fills> fills_of(const Workpiece& workpiece) {
  std::map<VoxelIndex, Fills> fills;
  workpiece.for_each_block([&](const BlockView& block) {
    for (int n = 0; n < kBlockVoxels; ++n) fills[block.origin][std::size_t(n)] = block.fill_of(n);
  });
  return fills;
}

std::set<VoxelIndex> differences(const std::map<VoxelIndex, Fills>& before, const std::map<VoxelIndex, Fills>& after) {
  std::set<VoxelIndex> origins;
  for (const auto& [origin, fills] : before) {
    const auto now = after.find(origin);
    if (now == after.end() || now->second != fills) origins.insert(origin);
  }
  return origins;
}

std::set<VoxelIndex> listed(const ChangedBlocks& changed) { return {changed.origins.begin(), changed.origins.end()}; }

TEST(ChangedBlocks, AreThoseWhoseVoxelsDiffer) {
  for (const char* name : {"axial_flat", "cone_layers"}) {
    const test::Scene& scene = test::find_scene(name);
    Simulation simulation = scene.make();
    std::map<VoxelIndex, Fills> before = fills_of(simulation.workpiece());
    std::size_t changed = 0;
    for (int tick = 0; tick < 120; ++tick) {
      const StepInput input = scene.input(tick);
      simulation.step(input.X_WH, input.V_WH, input.dt);
      std::map<VoxelIndex, Fills> after = fills_of(simulation.workpiece());
      const std::set<VoxelIndex> origins = listed(simulation.changed_blocks());
      ASSERT_EQ(origins, differences(before, after)) << name;
      EXPECT_TRUE(simulation.changed_blocks().complete);
      changed += origins.size();
      before = std::move(after);
    }
    EXPECT_GT(changed, 20U) << name;
  }
}

TEST(ChangedBlocks, AreNoneOfAStepThatIsRejectedOrCutsNothing) {
  const test::Scene& scene = test::find_scene("axial_flat");
  Simulation simulation = scene.make();
  for (int tick = 0; tick < 60; ++tick) simulation.step(scene.input(tick).X_WH, scene.input(tick).V_WH, 1e-3);
  ASSERT_FALSE(simulation.changed_blocks().origins.empty());
  simulation.step(scene.input(60).X_WH, scene.input(60).V_WH, -1);
  EXPECT_TRUE(simulation.changed_blocks().origins.empty());
  simulation.spindle().set_speed(0);
  simulation.step(scene.input(60).X_WH, scene.input(60).V_WH, 1e-3);
  EXPECT_TRUE(simulation.changed_blocks().origins.empty());
}

/// A ball that cuts its way into a block and then turns there without cutting.
struct BallInItsCavity {
  Simulation simulation{
      build_block({Vec3(-3, -3, -3) * units::mm, Vec3(3, 3, 0) * units::mm}, 2e-4, test::plain_material()),
      test::tool_of(SphereHead{test::kRadius}, 3000), test::on_foundation(1e13)};
  static constexpr double kDepth = 0.5e-3;  // [m] the ball's lowest point
  double height = 0;                        // [m] the ball's lowest point

  void move_to(double to, double by) {
    do {
      height += std::clamp(to - height, -by, by);
      simulation.step(Pose::from_translation({1e-5, 2e-5, height + test::kRadius}), {}, 1e-3);
    } while (height != to);
  }
  void wait(int steps) {
    for (int n = 0; n < steps; ++n) move_to(height, 1);
  }
};

TEST(ChangedBlocks, AreNoneOfASpinningHeadThatTouchesButRemovesNothing) {
  BallInItsCavity ball;
  ball.move_to(-ball.kDepth, 5e-6);
  ball.wait(3000);
  for (int n = 0; n < 100; ++n) {
    const std::uint64_t hash = ball.simulation.workpiece().hash();
    ball.wait(1);
    EXPECT_EQ(ball.simulation.changed_blocks().origins.empty(), ball.simulation.workpiece().hash() == hash);
  }
}

TEST(Simulation, KeepsItsRedoUntilSomethingIsCut) {
  BallInItsCavity ball;
  Simulation& simulation = ball.simulation;
  simulation.history().reserve(2000);
  ball.move_to(-ball.kDepth, 5e-6);
  ball.wait(3000);
  simulation.history().mark();
  ball.move_to(-1.5 * ball.kDepth, 5e-6);
  ball.move_to(2e-3, 5e-5);
  while (!simulation.history().undo(64)) {
  }
  ball.wait(1);
  const std::uint64_t shallow = simulation.workpiece().hash();
  int ticks_inside = 0;
  while (ball.height > -0.9 * ball.kDepth && simulation.workpiece().hash() == shallow) {  // into the cavity
    ASSERT_EQ(simulation.workpiece().redo_marks(), 1U) << ball.height;
    ticks_inside += ball.height < 0 ? 1 : 0;
    ball.move_to(std::max(ball.height - 5e-6, -0.9 * ball.kDepth), 5e-6);
  }
  EXPECT_GT(ticks_inside, 20);
  EXPECT_EQ(simulation.workpiece().redo_marks(), simulation.workpiece().hash() == shallow ? 1U : 0U);
}

// A stroke of 30 mm in one step: 600 sub-steps, which list most blocks many times.
TEST(ChangedBlocks, AreCompleteInALongSweepOrReportedAsIncomplete) {
  SimulationConfig config = test::on_foundation(1e14);
  config.max_sweep = 1000;
  config.reserved_blocks = 4096;
  Simulation simulation(
      build_block({Vec3(-1, -3, -3) * units::mm, Vec3(31, 3, 0) * units::mm}, 1e-4, test::plain_material()),
      test::tool_of(SphereHead{test::kRadius}, 3000), config);
  const std::map<VoxelIndex, Fills> before = fills_of(simulation.workpiece());
  simulation.step(Pose::from_translation(Vec3(-3e-3, 0, 0)), {}, 1e-3);
  simulation.step(Pose::from_translation(Vec3(27e-3, 0, 0)), {}, 1e-3);
  ASSERT_GT(simulation.last_result().sub_steps, 500);
  const std::set<VoxelIndex> origins = listed(simulation.changed_blocks());
  const std::set<VoxelIndex> expected = differences(before, fills_of(simulation.workpiece()));
  EXPECT_GT(expected.size(), 100U);
  EXPECT_TRUE(simulation.changed_blocks().complete);
  for (const VoxelIndex& origin : expected) EXPECT_TRUE(origins.contains(origin));
}

TEST(Simulation, ContinuesFromARestoredSnapshotAsFromTheFreshWorkpiece) {
  const test::Scene& scene = test::find_scene("axial_flat");
  Simulation simulation = scene.make();
  const auto forces_again = [&] {
    std::vector<Vec3> forces;
    for (int tick = 0; tick < 500; ++tick) {
      const StepInput input = scene.input(tick);
      forces.push_back(simulation.step(input.X_WH, input.V_WH, input.dt).force);
    }
    return forces;
  };
  const WorkpieceSnapshot fresh = simulation.workpiece().snapshot();
  const std::vector<Vec3> first = forces_again();
  const std::uint64_t hash = simulation.workpiece().hash();
  simulation.history().restore(fresh);
  EXPECT_EQ(forces_again(), first);
  EXPECT_EQ(simulation.workpiece().hash(), hash);
}

/// Counts the calls.
struct Counter final : StepObserver {
  void on_step(const ObservedStep& step) noexcept override {
    EXPECT_EQ(step.number, step.simulation.steps() - 1);
    ++steps;
  }
  void on_exchange() noexcept override { ++exchanges; }
  int steps = 0, exchanges = 0;
};

TEST(Simulation, CountsItsStepsAndTellsOfThemAndOfTheExchangesOfItsWorkpiece) {
  const test::Scene& scene = test::find_scene("axial_flat");
  Simulation simulation = scene.make();
  Counter told;
  simulation.observers().add(told);
  EXPECT_EQ(simulation.steps(), 0U);
  const WorkpieceSnapshot fresh = simulation.workpiece().snapshot();
  for (int tick = 0; tick < 3; ++tick) simulation.step(scene.input(tick).X_WH, {}, 1e-3);
  EXPECT_EQ(simulation.steps(), 3U);
  EXPECT_EQ(told.exchanges, 0);
  simulation.history().restore(fresh);
  EXPECT_EQ(simulation.steps(), 3U);
  EXPECT_EQ(told.exchanges, 1);
  simulation.reset(simulation.workpiece().clone());
  EXPECT_EQ(simulation.steps(), 0U);
  EXPECT_EQ(told.exchanges, 2);
  Pose nowhere;
  nowhere.translation.x() = std::nan("");
  simulation.step(nowhere, {}, 1e-3);
  EXPECT_EQ(told.steps, 4) << "a rejected step counts";
  Counter another;
  simulation.observers().add(another);
  EXPECT_THROW(simulation.observers().add(told), Error);
  simulation.step(scene.input(0).X_WH, {}, 1e-3);
  EXPECT_EQ(told.steps, 5);
  EXPECT_EQ(another.steps, 1);
  simulation.observers().remove(told);
  simulation.step(scene.input(1).X_WH, {}, 1e-3);
  EXPECT_EQ(told.steps, 5);
  EXPECT_EQ(another.steps, 2);
  std::array<Counter, StepObservers::kMax> many;
  for (std::size_t n = 1; n < many.size(); ++n) simulation.observers().add(many[n]);
  EXPECT_THROW(simulation.observers().add(many[0]), Error);
  EXPECT_EQ(simulation.observers().all().size(), StepObservers::kMax);
  simulation.spindle().set_speed(-7 * units::rad_per_s);
  EXPECT_EQ(simulation.spindle().setting(), -7);
}

}  // namespace
}  // namespace hapticut::changed_blocks_test
