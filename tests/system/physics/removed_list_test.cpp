// SPDX-License-Identifier: Apache-2.0
// The list of removed voxels is an option of the step: without it, everything else has the same bits.
#include <gtest/gtest.h>

#include <utility>

#include "experiments/setup/cutting.hpp"
#include "hapticut/simulation/coupling.hpp"

namespace hapticut::removed_list_test {
namespace {

using namespace test;
using units::mm;

Simulation plunging_ball(bool lists, ContactTime time = ContactTime::middle) {
  SimulationConfig config;
  config.list_removed_voxels = lists;
  config.contact_time = time;
  return Simulation(plain_block(), tool_of(SphereHead{kRadius}, kSpin), config);
}

void expect_equal_but_for_the_list(const StepResult& listed, const StepResult& bare) {
  EXPECT_TRUE(bare.removed_voxels.empty());
  EXPECT_EQ(bare.force, listed.force);
  EXPECT_EQ(bare.torque, listed.torque);
  EXPECT_EQ(bare.removed_volume, listed.removed_volume);
  EXPECT_EQ(bare.energy.cutting, listed.energy.cutting);
  EXPECT_EQ(bare.energy.turnover, listed.energy.turnover);
  EXPECT_EQ(bare.status, listed.status);
}

TEST(RemovedList, CanBeLeftOutAndChangesNothingElse) {
  Simulation listing = plunging_ball(true), bare = plunging_ball(false);
  std::size_t listed = 0;
  for (int tick = 0; tick < 200; ++tick) {
    const Vec3 to(0, 0, kRadius - kFeed * kTick * tick), velocity(0, 0, -kFeed);
    const StepResult& result = step_to(listing, to, velocity);
    listed += result.removed_voxels.size();
    expect_equal_but_for_the_list(result, step_to(bare, to, velocity));
  }
  EXPECT_GT(listed, 100U);
  EXPECT_EQ(bare.totals().removed_volume, listing.totals().removed_volume);
}

TEST(RemovedList, StaysLeftOutAfterAnExchangeOfTheTool) {
  Simulation simulation = plunging_ball(false);
  PreparedTool prepared(tool_of(SphereHead{0.8 * kRadius}, kSpin), kVoxel, simulation.config());
  ASSERT_TRUE(simulation.exchange(prepared));
  double removed = 0;
  for (int tick = 0; tick < 200; ++tick) {
    const StepResult& result = step_to(simulation, {0, 0, kRadius - kFeed * kTick * tick}, {0, 0, -kFeed});
    removed += result.removed_volume;
    ASSERT_TRUE(result.removed_voxels.empty());
    ASSERT_FALSE(has_any(result.status, StepStatus::removed_list_full));
  }
  EXPECT_GT(removed, 0);
}

TEST(RemovedList, IsLeftOutBehindACouplingToo) {
  Simulation listing = plunging_ball(true, ContactTime::end), bare = plunging_ball(false, ContactTime::end);
  VirtualCoupling with_list(listing, {}), without(bare, {});
  std::size_t listed = 0;
  constexpr double kGap = 0.05 * mm;        // the tool waits until the hand is free
  for (int tick = 0; tick < 750; ++tick) {  // the spring of the coupling is soft
    const Pose hand = Pose::from_translation({0, 0, kRadius + kGap - kFeed * kTick * tick});
    const CoupledResult& result = with_list.step(hand, {Vec3(0, 0, -kFeed), Vec3::Zero()}, kTick);
    listed += result.removed_voxels.size();
    const CoupledResult& other = without.step(hand, {Vec3(0, 0, -kFeed), Vec3::Zero()}, kTick);
    ASSERT_TRUE(other.removed_voxels.empty());
    ASSERT_EQ(other.hand.force, result.hand.force);
    ASSERT_EQ(other.removed_volume, result.removed_volume);
    ASSERT_EQ(other.status, result.status);
  }
  EXPECT_GT(listed, 100U);
}

TEST(RemovedList, IsNotCopiedByACouplingWithoutLists) {
  Simulation simulation = plunging_ball(true, ContactTime::end), other = plunging_ball(true, ContactTime::end);
  VirtualCoupling with_lists(simulation, {}), without(other, {}, VirtualCoupling::Lists{});
  std::size_t listed = 0;
  for (int tick = 0; tick < 750; ++tick) {
    const Pose hand = Pose::from_translation({0, 0, kRadius + 0.05 * mm - kFeed * kTick * tick});
    const CoupledResult& result = with_lists.step(hand, {Vec3(0, 0, -kFeed), Vec3::Zero()}, kTick);
    const CoupledResult& bare = without.step(hand, {Vec3(0, 0, -kFeed), Vec3::Zero()}, kTick);
    listed += other.last_result().removed_voxels.size();
    ASSERT_TRUE(bare.removed_voxels.empty());
    ASSERT_EQ(bare.changed_blocks.complete, result.changed_blocks.origins.empty());
    ASSERT_EQ(bare.hand.force, result.hand.force);
    ASSERT_EQ(bare.status, result.status);
  }
  EXPECT_GT(listed, 100U);
}

}  // namespace
}  // namespace hapticut::removed_list_test
