// SPDX-License-Identifier: Apache-2.0
// The work of a step has a known upper bound, can be limited, and can be timed.
#include <gtest/gtest.h>
#include <sys/resource.h>

#include "experiments/setup/cutting.hpp"
#include "experiments/setup/random_pose.hpp"
#include "hapticut/core/errors.hpp"
#include "hapticut/force/laws/thesis.hpp"
#include "hapticut/tool/catalogue.hpp"
#include "support/scenes.hpp"

namespace hapticut::worst_case_test {
namespace {

using namespace test;
using units::deg;
using units::mm;

/// A block that can bury every head of these tests.
Workpiece deep_block() {
  return build_block({Vec3::Constant(-4 * mm), Vec3::Constant(4 * mm)}, kVoxel, plain_material());
}

std::vector<ToolHead> heads() {
  return {SphereHead{1 * mm}, SphereHead{0.12 * mm}, ConeHead{20 * deg, 2 * mm}, FlatHead{0.6 * mm, 1.5 * mm},
          ConeHead{70 * deg, 0.5 * mm}};
}

TEST(WorstCase, IsNeverExceededAndNotMuchTooLarge) {
  RandomPoses random(5);
  for (const ToolHead& head : heads()) {
    SimulationConfig config;
    config.removal = RemovalLaw::none;
    Simulation simulation(deep_block(), Tool(head), config);
    const WorstCase worst = simulation.worst_case();
    int max_voxels = 0;
    for (int trial = 0; trial < 50; ++trial) {
      const Pose pose = {random.rotation(), random.vector(1 * mm)};
      simulation.step(pose, {}, 1e-3);  // a jump, which is accepted the second time
      max_voxels = std::max(max_voxels, simulation.step(pose, {}, 1e-3).contact.voxels);
    }
    EXPECT_GT(max_voxels, 0);
    EXPECT_LE(std::size_t(max_voxels), worst.voxels);
    // Every voxel that the surface may touch counts fully: two layers around a cone of ten voxels across.
    if (head.volume() > 500 * std::pow(kVoxel, 3)) {
      EXPECT_LT(double(worst.voxels), 4.0 * max_voxels);
    }
    EXPECT_EQ(worst.level_of_detail, 1);
    EXPECT_EQ(worst.sub_steps, config.max_sweep);
  }
}

/// A ball goes down until it is half buried, then moves sideways and cuts.
struct Groove {
  Vec3 force = Vec3::Zero();  // [N] mean over the steady part
  double removed = 0;         // [m^3]
  double closure = 0;
  int max_evaluated = 0;
  int highest_level = 0;
  StepStatus status = StepStatus::ok;
};

Groove cut_groove(std::size_t budget) {
  SimulationConfig config = on_foundation(1e13);
  config.voxel_budget = budget;
  Material hard = plain_material();
  hard.specific_cutting_energy = 3e9;
  Simulation simulation(build_block({Vec3(-4 * mm, -4 * mm, -3 * mm), Vec3(4 * mm, 4 * mm, 0)}, kVoxel, hard),
                        tool_of(SphereHead{1.5 * mm}, 3000), config);
  Groove groove;
  constexpr int kSteps = 800;
  for (int i = 0; i < kSteps; ++i) {
    const Vec3 velocity = i < kSteps / 2 ? Vec3(0, 0, -4e-3) : Vec3(4e-3, 0, 0);
    const Vec3 position = Vec3(-1 * mm, 0.03 * mm, 1.5 * mm) + std::min(i + 1, kSteps / 2) * Vec3(0, 0, -4e-6) +
                          std::max(0, i + 1 - kSteps / 2) * Vec3(4e-6, 0, 0);
    const StepResult& result = simulation.step(Pose::from_translation(position), {velocity, Vec3::Zero()}, 1e-3);
    if (i > kSteps * 3 / 4) groove.force += result.force / (kSteps / 4.0);
    groove.removed += result.removed_volume;
    groove.max_evaluated = std::max(groove.max_evaluated, result.contact.voxels / result.contact.level_of_detail);
    groove.highest_level = std::max(groove.highest_level, result.contact.level_of_detail);
    groove.status |= result.status;
  }
  groove.closure = simulation.last_result().energy.closure();
  return groove;
}

TEST(LevelOfDetail, KeepsTheBudgetTheForceAndTheCut) {
  const Groove whole = cut_groove(0);
  ASSERT_GT(whole.max_evaluated, 4500);
  EXPECT_EQ(whole.highest_level, 1);
  EXPECT_FALSE(has_any(whole.status, StepStatus::detail_reduced));
  const Groove reduced = cut_groove(4096);
  EXPECT_LE(reduced.max_evaluated, 4096);
  EXPECT_LE(reduced.highest_level, 3)
      << "2 is enough, but voxels just outside count too, because their parts may reach inside";
  EXPECT_TRUE(has_any(reduced.status, StepStatus::detail_reduced));
  EXPECT_LT((reduced.force - whole.force).norm(), 0.07 * whole.force.norm()) << "the just noticeable difference";
  EXPECT_NEAR(reduced.removed, whole.removed, 0.02 * whole.removed);
  EXPECT_LT(std::abs(reduced.closure), 0.02);
}

TEST(LevelOfDetail, IsOnlyReducedWhereTheHeadTouchesMoreThanTheBudget) {
  SimulationConfig config;
  config.voxel_budget = 4096;
  config.removal = RemovalLaw::none;
  const Tool tool(SphereHead{1.5 * mm});
  Simulation simulation(deep_block(), tool, config), deeper(deep_block(), tool, config);
  EXPECT_GT(simulation.worst_case().level_of_detail, 1);
  EXPECT_LE(simulation.worst_case().voxels, 4096U);
  const StepResult& shallow = simulation.step(Pose::from_translation(Vec3(0, 0, 5.4 * mm)), {}, 1e-3);
  EXPECT_GT(shallow.contact.voxels, 0);
  EXPECT_FALSE(has_any(shallow.status, StepStatus::detail_reduced));
  const StepResult& deep = deeper.step(Pose::from_translation(Vec3(0, 0, 0)), {}, 1e-3);
  EXPECT_TRUE(has_any(deep.status, StepStatus::detail_reduced));
}

TEST(LevelOfDetail, IsRefusedForACustomLawAndForAnAbsurdBudget) {
  SimulationConfig config;
  config.voxel_budget = 10;
  EXPECT_THROW(Simulation(deep_block(), Tool(SphereHead{1 * mm}), config), Error);
  config.voxel_budget = 10000;
  config.law = std::make_shared<ThesisLaw>(ThesisLaw::Constants{});
  EXPECT_THROW(Simulation(deep_block(), Tool(SphereHead{1 * mm}), config), Error);
}

TEST(StageTimes, AreMeasuredOnlyWhenAskedFor) {
  for (const bool asked : {false, true}) {
    SimulationConfig config;
    config.stage_times = asked;
    Simulation simulation(deep_block(), tool_of(SphereHead{kRadius}, kSpin), config);
    (void)step_to(simulation, Vec3::Zero());
    const StageTimes& times = simulation.stage_times();
    for (const double time :
         {times.check_input, times.find_start, times.plan_sweep, times.plan_sub_step, times.find_blocks,
          times.press_and_cut, times.remove_emptied, times.tether_deep_ball, times.add_friction, times.book_energy,
          times.transport_to_handle, times.drive_spindle, times.advance_spindle, times.give_output}) {
      EXPECT_TRUE(asked ? time > 0 : time == 0) << time;
    }
  }
}

TEST(PageFaults, DoNotHappenInTheStepAfterSetUp) {
  for (const test::Scene& scene : test::scenes()) {
    std::vector<StepInput> inputs;
    for (int tick = 0; tick < 2000; ++tick) inputs.push_back(scene.input(tick));
    // One simulation touches the pages of the program. It stays alive, so that the other gets new memory.
    Simulation first = scene.make(), simulation = scene.make();
    for (const StepInput& input : inputs) (void)first.step(input.X_WH, input.V_WH, input.dt);
    rusage before{}, after{};
    getrusage(RUSAGE_THREAD, &before);
    for (const StepInput& input : inputs) (void)simulation.step(input.X_WH, input.V_WH, input.dt);
    getrusage(RUSAGE_THREAD, &after);
    EXPECT_EQ(after.ru_majflt - before.ru_majflt, 0) << scene.name;
    EXPECT_EQ(after.ru_minflt - before.ru_minflt, 0) << scene.name;
  }
}

}  // namespace
}  // namespace hapticut::worst_case_test
