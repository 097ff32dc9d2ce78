// SPDX-License-Identifier: Apache-2.0
// Marks, undo and redo, without an allocation, while a simulation runs.
#include <gtest/gtest.h>

#include <algorithm>
#include <random>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "experiments/setup/cutting.hpp"
#include "hapticut/simulation/simulation.hpp"
#include "hapticut/workpiece/builders.hpp"
#include "support/refusal.hpp"

namespace hapticut::undo_test {
namespace {

/// A slab whose faces lie within voxels, so that it has uniform, mixed, and partly filled blocks.
Simulation slab(std::size_t undo_blocks) {
  SimulationConfig config;
  config.reference_stiffness = 1e14;
  config.reserved_blocks = 2000;
  Material below = test::plain_material();
  below.name = "below";
  Simulation simulation(build_layered_slab({Vec3(-4e-3, -4e-3, -4e-3), Vec3(4e-3, 4e-3, 0.3e-4)}, 1e-4,
                                           {{test::plain_material(), 1.23e-3}, {below, 2.8e-3}}),
                        Tool(SphereHead{1e-3}, RayHandle{0}, Spindle{3000 * units::rad_per_s}), config);
  simulation.history().reserve(undo_blocks);
  return simulation;
}

/// Moves a ball along random paths through the slab; each path starts above the slab.
class Wandering {
 public:
  explicit Wandering(unsigned seed) : random_(seed) { begin_anew(); }
  void cut(Simulation& simulation, int steps) {
    if (simulation.next_step_is_first()) begin_anew();  // otherwise the tool would wait at its present place
    for (int n = 0; n < steps; ++n) {
      position_ += 2e-5 * direction_;
      if (position_.head<2>().norm() > 3e-3 || position_.z() < -2.5e-3) begin_anew();
      last_force = simulation.step(Pose::from_translation(position_), {}, 1e-3).force;
    }
  }
  Vec3 last_force = Vec3::Zero();

 private:
  void begin_anew() {
    std::uniform_real_distribution<double> number(-1, 1);
    position_ = Vec3(2e-3 * number(random_), 2e-3 * number(random_), 1.1e-3);
    direction_ = Vec3(number(random_), number(random_), -1).normalized();
  }
  std::mt19937 random_;
  Vec3 position_, direction_;
};

void undo_by(Simulation& simulation, std::size_t max_blocks) {
  while (!simulation.history().undo(max_blocks)) {
    EXPECT_LE(simulation.changed_blocks().origins.size(), max_blocks);
    EXPECT_TRUE(simulation.changed_blocks().complete);
  }
}
void redo_by(Simulation& simulation, std::size_t max_blocks) {
  while (!simulation.history().redo(max_blocks)) EXPECT_LE(simulation.changed_blocks().origins.size(), max_blocks);
}

TEST(Undo, MakesTheSameCutFeelTheSameAgain) {
  Simulation simulation = slab(4000);
  Wandering(3).cut(simulation, 400);
  simulation.history().mark();
  EXPECT_TRUE(simulation.history().undo(1))
      << "nothing was cut, but the next step is the first of the tool, as in the second run";
  simulation.history().mark();
  Wandering tool(4);
  tool.cut(simulation, 300);
  const Vec3 first = tool.last_force;
  const std::uint64_t cut = simulation.workpiece().hash();
  undo_by(simulation, 16);
  Wandering again(4);
  again.cut(simulation, 300);
  EXPECT_EQ(again.last_force, first);
  EXPECT_EQ(simulation.workpiece().hash(), cut);
  EXPECT_TRUE(simulation.history().undo(1)) << "there is no mark left";
}

TEST(Undo, ReportsEveryBlockThatItRestores) {
  Simulation simulation = slab(4000);
  std::set<VoxelIndex> cut, named;
  simulation.history().mark();
  Wandering tool(5);
  for (int n = 0; n < 500; ++n) {
    tool.cut(simulation, 1);
    const ChangedBlocks changed = simulation.changed_blocks();
    cut.insert(changed.origins.begin(), changed.origins.end());
  }
  for (bool done = false; !done;) {
    done = simulation.history().undo(7);
    const ChangedBlocks changed = simulation.changed_blocks();
    EXPECT_TRUE(changed.complete);
    named.insert(changed.origins.begin(), changed.origins.end());
  }
  EXPECT_TRUE(std::includes(named.begin(), named.end(), cut.begin(), cut.end()));
}

TEST(Undo, DeletesTheOldestMarkWhenTheMemoryIsFullAndRedoNeedsNoMemory) {
  Simulation simulation = slab(100);
  Wandering tool(6);
  std::vector<std::uint64_t> hashes;
  for (int n = 0; n < 10; ++n) {
    hashes.push_back(simulation.workpiece().hash());
    simulation.history().mark();
    tool.cut(simulation, 60);
  }
  const std::uint64_t last = simulation.workpiece().hash();
  const std::size_t kept = simulation.workpiece().marks();
  EXPECT_GT(kept, 0U);
  EXPECT_LT(kept, 10U);
  for (std::size_t n = 0; n < kept; ++n) {
    undo_by(simulation, 8);
    EXPECT_EQ(simulation.workpiece().hash(), hashes[9 - n]);
  }
  EXPECT_EQ(simulation.workpiece().redo_marks(), kept);
  for (std::size_t n = 0; n < kept; ++n) redo_by(simulation, 8);
  EXPECT_EQ(simulation.workpiece().hash(), last);

  Simulation tiny = slab(1);
  tiny.history().mark();
  tool.cut(tiny, 100);
  EXPECT_EQ(tiny.workpiece().marks(), 0U) << "one block does not suffice for undo";
  EXPECT_TRUE(tiny.history().undo(1));
}

TEST(Undo, DoesNothingWithoutMemoryAndBeginsAfreshAfterARestore) {
  Simulation without = slab(0);
  EXPECT_FALSE(without.history().mark()) << "otherwise `undo` would seem to work";
  EXPECT_EQ(without.workpiece().marks(), 0U);
  EXPECT_EQ(without.workpiece().redo_marks(), 0U);
  EXPECT_TRUE(without.history().undo(10));
  EXPECT_TRUE(without.history().redo(10));

  Simulation simulation = slab(1000);
  const WorkpieceSnapshot fresh = simulation.workpiece().snapshot();
  const std::uint64_t hash = simulation.workpiece().hash();
  simulation.history().mark();
  Wandering tool(7);
  tool.cut(simulation, 200);
  simulation.history().restore(fresh);
  EXPECT_EQ(simulation.workpiece().marks(), 0U);
  simulation.history().mark();
  tool.cut(simulation, 200);
  EXPECT_NE(simulation.workpiece().hash(), hash);
  undo_by(simulation, 10);
  EXPECT_EQ(simulation.workpiece().hash(), hash);
}

TEST(Undo, ArrivesAlsoWhereNoBlocksOrAllBlocksAreAllowedACall) {
  for (const std::size_t max_blocks : {std::size_t(0), ~std::size_t(0)}) {
    Simulation simulation = slab(4000);
    const std::uint64_t hash = simulation.workpiece().hash();
    simulation.history().mark();
    Wandering tool(8);
    tool.cut(simulation, 2000);
    EXPECT_NE(simulation.workpiece().hash(), hash);
    int calls = 1;
    while (!simulation.history().undo(max_blocks) && calls < 10000) ++calls;
    EXPECT_EQ(simulation.workpiece().hash(), hash) << max_blocks;
    if (max_blocks == 0) {
      EXPECT_GT(calls, 100) << "one block per call";
    } else {
      EXPECT_EQ(calls, 1);
    }
  }
}

TEST(Undo, KeepsItsMemoryWhenTheSimulationIsReset) {
  Simulation simulation = slab(1000);
  const Workpiece fresh = simulation.workpiece().clone();
  Wandering(9).cut(simulation, 100);
  simulation.history().mark();
  simulation.reset(fresh.clone());
  EXPECT_EQ(simulation.workpiece().marks(), 0U) << "of another workpiece";
  EXPECT_EQ(simulation.workpiece().undo_blocks(), 1000U);
  const std::uint64_t hash = simulation.workpiece().hash();
  simulation.history().mark();
  EXPECT_EQ(simulation.workpiece().marks(), 1U);
  Wandering(10).cut(simulation, 200);
  EXPECT_NE(simulation.workpiece().hash(), hash);
  undo_by(simulation, 10);
  EXPECT_EQ(simulation.workpiece().hash(), hash);

  // A workpiece keeps its reserved undo memory if the simulation had no undo memory.
  Simulation without = slab(0);
  Workpiece own = fresh.clone();
  own.reserve_undo(7);
  without.reset(std::move(own));
  EXPECT_EQ(without.workpiece().undo_blocks(), 7U);
}

TEST(Undo, RefusesImpossibleMemoryAndChangesNothingThen) {
  Simulation simulation = slab(100);
  simulation.history().mark();
  for (const std::size_t blocks : {~std::size_t(0), std::size_t(1) << 40, (std::size_t(1) << 22) + 1}) {
    const std::string number = std::to_string(blocks);
    test::expect_refused([&] { simulation.history().reserve(blocks); }, {number.c_str(), "Reserve"});
  }
  EXPECT_EQ(simulation.workpiece().marks(), 1U);
  EXPECT_EQ(simulation.workpiece().undo_blocks(), 100U);
}

// Cuts, marks, undo and redo at random. Each restored state equals the saved state bit by bit, including the number of
// blocks in the pool.
TEST(Redo, RestoresEveryUndoneStateUntilSomethingElseIsCut) {
  struct State {
    std::uint64_t hash;
    std::size_t free_blocks;
    std::int64_t solid;
    bool operator==(const State&) const = default;
  };
  for (unsigned seed = 1; seed <= 5; ++seed) {
    Simulation simulation = slab(4000);
    const Workpiece& workpiece = simulation.workpiece();
    const auto state = [&] { return State{workpiece.hash(), workpiece.reserved_blocks(), workpiece.solid_voxels()}; };
    Wandering tool(seed);
    std::mt19937 random(100 + seed);
    std::vector<State> states;  // at each mark, at present, and after each undone mark
    std::size_t here = 0;
    int back = 0, forth = 0;
    states.push_back(state());
    for (int n = 0; n < 100; ++n) {
      const auto what = random() % 5;
      if (what < 2) {
        simulation.history().mark();
        do tool.cut(simulation, 1 + int(random() % 200));
        while (state() == states[here]);  // repeats while the tool is in the air
        states.resize(++here);
        states.push_back(state());
      } else if (what == 2 || what == 3) {
        if (here == 0) continue;
        undo_by(simulation, 1 + random() % 20);
        ASSERT_EQ(state(), states[--here]) << seed << ", " << n;
        ++back;
      } else {
        redo_by(simulation, 1 + random() % 20);
        if (here + 1 < states.size()) ++here, ++forth;
        ASSERT_EQ(state(), states[here]) << seed << ", " << n;
      }
      ASSERT_EQ(simulation.workpiece().marks(), here);
      ASSERT_EQ(simulation.workpiece().redo_marks(), states.size() - 1 - here);
    }
    EXPECT_GT(back, 10);
    EXPECT_GT(forth, 3);
  }
}

TEST(Redo, EndsWithACutAndOnlyThen) {
  Simulation simulation = slab(4000);
  simulation.history().mark();
  Wandering(11).cut(simulation, 300);
  const std::uint64_t cut = simulation.workpiece().hash();
  undo_by(simulation, 16);
  EXPECT_EQ(simulation.workpiece().redo_marks(), 1U);
  for (int n = 0; n < 50; ++n) (void)simulation.step(Pose::from_translation({0, 0, 5e-3}), {}, 1e-3);
  EXPECT_EQ(simulation.workpiece().redo_marks(), 1U) << "a step in the air cuts nothing";
  redo_by(simulation, 16);
  EXPECT_EQ(simulation.workpiece().hash(), cut);
  EXPECT_EQ(simulation.workpiece().redo_marks(), 0U);
  EXPECT_TRUE(simulation.history().redo(16)) << "there is nothing to redo";
  undo_by(simulation, 16);
  Wandering(12).cut(simulation, 300);
  EXPECT_EQ(simulation.workpiece().redo_marks(), 0U);
  EXPECT_TRUE(simulation.history().redo(16));
}

TEST(Redo, ReversesHalfWay) {
  Simulation simulation = slab(4000);
  const std::uint64_t whole = simulation.workpiece().hash();
  simulation.history().mark();
  Wandering(13).cut(simulation, 600);
  const std::uint64_t cut = simulation.workpiece().hash();
  EXPECT_FALSE(simulation.history().undo(5));
  EXPECT_EQ(simulation.workpiece().redo_marks(), 1U) << "a mark that is half undone can be redone";
  redo_by(simulation, 3);
  EXPECT_EQ(simulation.workpiece().hash(), cut);
  undo_by(simulation, 100);
  EXPECT_FALSE(simulation.history().redo(5));
  undo_by(simulation, 2);
  EXPECT_EQ(simulation.workpiece().hash(), whole);
  EXPECT_EQ(simulation.workpiece().marks(), 0U);
  redo_by(simulation, 1000);
  EXPECT_EQ(simulation.workpiece().hash(), cut);
}

TEST(Undo, KeepsNoMoreThan64MarksThereAndBack) {
  Simulation simulation = slab(1000);
  for (int n = 0; n < 100; ++n) simulation.history().mark();
  EXPECT_EQ(simulation.workpiece().marks(), 64U);
  for (int n = 0; n < 40; ++n) EXPECT_TRUE(simulation.history().undo(8));
  for (int n = 0; n < 100; ++n) simulation.history().mark();
  EXPECT_LE(simulation.workpiece().marks() + simulation.workpiece().redo_marks(), 64U);
}

}  // namespace
}  // namespace hapticut::undo_test
