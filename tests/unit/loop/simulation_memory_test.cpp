// SPDX-License-Identifier: Apache-2.0
#include "simulation/simulation_memory.hpp"

#include <gtest/gtest.h>

#include "hapticut/core/errors.hpp"
#include "io/vdb/vdb_bytes.hpp"
#include "support/scenes.hpp"

namespace hapticut {
namespace {

constexpr int kBefore = 120, kAfter = 40;  // steps

void make_steps(Simulation& simulation, const test::Scene& scene, int from, int count) {
  for (int tick = from; tick < from + count; ++tick) {
    const StepInput input = scene.input(tick);
    (void)simulation.step(input.X_WH, input.V_WH, input.dt);
  }
}

TEST(SimulationMemory, ACopyOfAnySceneHasTheSameMemoryAfterTheSameSteps) {
  for (const test::Scene& scene : test::scenes()) {
    SCOPED_TRACE(scene.name);
    Simulation simulation = scene.make();
    for (int made = 0; made <= kBefore; made += kBefore) {
      make_steps(simulation, scene, int(simulation.steps()), made - int(simulation.steps()));
      Simulation copy = copy_of(simulation);
      ASSERT_EQ(SimulationMemory::bytes_of(copy), SimulationMemory::bytes_of(simulation));
      if (made == 0) continue;
      make_steps(copy, scene, made, kAfter);
      make_steps(simulation, scene, made, kAfter);
      ASSERT_EQ(copy.last_result().force, simulation.last_result().force);
      ASSERT_EQ(copy.workpiece().hash(), simulation.workpiece().hash());
      ASSERT_EQ(copy.totals().touched, simulation.totals().touched);
      ASSERT_EQ(copy.totals().first_touch, simulation.totals().first_touch);
      ASSERT_FALSE(copy.is_fresh());
      ASSERT_EQ(SimulationMemory::bytes_of(copy), SimulationMemory::bytes_of(simulation));
    }
  }
}

TEST(SimulationMemory, ContinuesWithTheSameBitsOnTheBytesOfAFile) {
  for (const test::Scene& scene : test::scenes()) {
    SCOPED_TRACE(scene.name);
    Simulation simulation = scene.make();
    make_steps(simulation, scene, 0, kBefore);
    simulation.spindle().hold(true);  // a standing head sums whole voxels strip by strip
    Simulation copy = SimulationMemory::restored(workpiece_of_vdb(vdb_bytes(simulation.workpiece())), simulation.tool(),
                                                 simulation.config(), SimulationMemory::bytes_of(simulation));
    for (int tick = kBefore; tick < kBefore + 5 * kAfter; ++tick) {
      make_steps(copy, scene, tick, 1);
      make_steps(simulation, scene, tick, 1);
      ASSERT_EQ(copy.last_result().force, simulation.last_result().force) << tick;
    }
    ASSERT_EQ(SimulationMemory::bytes_of(copy), SimulationMemory::bytes_of(simulation));
  }
}

TEST(SimulationMemory, OfAnotherLengthIsRefused) {
  const test::Scene& scene = test::scenes().front();
  const Simulation simulation = scene.make();
  const std::string bytes = SimulationMemory::bytes_of(simulation);
  const auto restored = [&](const std::string& given) {
    return SimulationMemory::restored(simulation.workpiece().clone(), simulation.tool(), simulation.config(), given);
  };
  EXPECT_EQ(SimulationMemory::bytes_of(restored(bytes)), bytes);
  EXPECT_THROW((void)restored(bytes.substr(0, bytes.size() - 1)), Error);
  EXPECT_THROW((void)restored(bytes + '\0'), Error);
  EXPECT_THROW((void)restored(""), Error);
}

TEST(SimulationMemory, RefusesMarksForUndo) {
  Simulation simulation = test::scenes().front().make();
  simulation.history().reserve(8);
  ASSERT_TRUE(simulation.history().mark());
  EXPECT_THROW((void)copy_of(simulation), Error);
  simulation.history().reserve(8);
  EXPECT_EQ(copy_of(simulation).workpiece().marks(), 0U);
}

}  // namespace
}  // namespace hapticut
