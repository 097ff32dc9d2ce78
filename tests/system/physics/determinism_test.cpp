// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <bit>

#include "support/scenes.hpp"

namespace hapticut::determinism_test {
namespace {

/// Every bit that a run of a scene produces: forces, torques, energies and the workpiece at the end.
std::uint64_t run_hash(const test::Scene& scene, int steps) {
  Simulation simulation = scene.make();
  std::uint64_t hash = 0;
  const auto mix = [&](double value) {
    hash = (hash ^ std::bit_cast<std::uint64_t>(value)) * 0x100000001b3ULL;
    hash ^= hash >> 31;
  };
  for (int tick = 0; tick < steps; ++tick) {
    const StepInput input = scene.input(tick);
    const StepResult& result = simulation.step(input.pose, input.velocity, input.dt);
    for (int axis = 0; axis < 3; ++axis) {
      mix(result.force[axis]);
      mix(result.torque[axis]);
    }
    mix(result.removed_volume);
    mix(double(result.removed_voxels.size()));
    mix(result.energy.imbalance());
  }
  return hash ^ simulation.workpiece().hash();
}

TEST(Determinism, TheSameInputGivesTheSameBitsInEveryScene) {
  for (const test::Scene& scene : test::scenes()) EXPECT_EQ(run_hash(scene, 1500), run_hash(scene, 1500)) << scene.name;
}

TEST(Determinism, ARestoredSnapshotAndAFreshWorkpieceContinueAlike) {
  const test::Scene& scene = test::find_scene("axial_flat");
  const auto forces_of = [&](Simulation& simulation) {
    std::vector<Vec3> forces;
    for (int tick = 0; tick < 500; ++tick) {
      const StepInput input = scene.input(tick);
      forces.push_back(simulation.step(input.pose, input.velocity, input.dt).force);
    }
    return forces;
  };
  Simulation simulation = scene.make();
  const WorkpieceSnapshot fresh = simulation.snapshot();
  const std::vector<Vec3> first = forces_of(simulation);
  const std::uint64_t hash = simulation.workpiece().hash();
  simulation.restore(fresh);
  EXPECT_EQ(forces_of(simulation), first);
  EXPECT_EQ(simulation.workpiece().hash(), hash);
}

}  // namespace
}  // namespace hapticut::determinism_test
