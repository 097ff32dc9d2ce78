// SPDX-License-Identifier: Apache-2.0
// States that change a step and that no pose shows: what a replay must know of them.
#include "hapticut/io/recording/replay.hpp"

#include <gtest/gtest.h>

#include <functional>
#include <optional>
#include <string>

#include "experiments/setup/cutting.hpp"
#include "hapticut/tool/motors.hpp"
#include "hapticut/workpiece/builders.hpp"
#include "io/recording/hdf5.hpp"
#include "support/recordings.hpp"
#include "support/temporary_folder.hpp"

namespace hapticut::replay_test {
namespace {

using test::expect_repeats;
using test::patient;
using test::StepLog;
using test::TemporaryFolder;

/// A ball over a block of a material that it crushes when it stands.
Simulation soft_cut(const Spindle& spindle = Spindle{3000 * units::rad_per_s}, const SimulationConfig& config = {}) {
  Material material = test::plain_material();
  material.compressive_strength = 2e6;
  return {build_block({Vec3(-2e-3, -2e-3, -3e-3), Vec3(2e-3, 2e-3, 0)}, 1e-4, material),
          Tool(SphereHead{1e-3}, RayHandle{0}, spindle), config};
}

/// The ball below the face by a depth.
Pose at_depth(double depth) { return Pose::from_translation(Vec3(2.3e-5, 1.1e-5, 1e-3 - depth)); }

/// Straight down at 2 mm/s from just above the face.
StepInput plunge(int tick) { return {at_depth(2e-6 * tick - 1e-5), {Vec3(0, 0, -2e-3), Vec3::Zero()}, 1e-3}; }

/// Records a plunge, and expects a replay to have the same bits.
/// @param between  called before each step
/// @return status bits of all steps
StepStatus record_and_repeat(Simulation& simulation, int steps, const std::function<void(int tick)>& between,
                             const std::filesystem::path& path) {
  const StepLog log(simulation);
  Recorder recorder(path, simulation, patient());
  StepStatus seen = StepStatus::ok;
  for (int tick = 0; tick < steps; ++tick) {
    between(tick);
    const StepInput input = plunge(tick);
    seen |= simulation.step(input.X_WH, input.V_WH, input.dt).status;
  }
  recorder.close();
  expect_repeats(path, log);
  return seen;
}

// Regression: the replay crushed what a held spindle leaves as it is.
TEST(Replay, OfAHeldSpindleCrushesNothing) {
  const TemporaryFolder folder;
  for (const bool from_the_beginning : {true, false}) {
    Simulation held = soft_cut(), halted = soft_cut();
    if (from_the_beginning) held.spindle().hold(true);
    const StepStatus seen = record_and_repeat(
        held, 200, [&](int tick) { held.spindle().hold(from_the_beginning || tick >= 20); }, folder / "a.h5");
    EXPECT_FALSE(has_any(seen, StepStatus::material_crushed)) << "a held head crushes nothing, a turning one cuts";
    const StepStatus other = record_and_repeat(
        halted, 200, [&](int) { halted.spindle().halt(); }, folder / "b.h5");
    EXPECT_TRUE(has_any(other, StepStatus::material_crushed)) << "a halted head crushes this material";
  }
}

TEST(Replay, FollowsHaltsAndSettingsOfAHeldSpindle) {
  const TemporaryFolder folder;
  Simulation simulation = soft_cut(common_spindle(MotorKind::electric, 40000 * units::rpm));
  (void)record_and_repeat(
      simulation, 300,
      [&](int tick) {
        if (tick % 50 == 10) simulation.spindle().hold(true);
        if (tick % 50 == 15) simulation.spindle().set_speed((1000 + 10 * tick) * units::rad_per_s);
        if (tick == 120 || tick == 123) simulation.spindle().halt();
        if (tick % 50 == 30) simulation.spindle().hold(false);
        if (tick == 232) simulation.spindle().hold(true), simulation.spindle().hold(false);
      },
      folder / "a.h5");
}

// A motor without inertia that its load has stalled is at its speed again when that speed is set.
TEST(Replay, FollowsASettingThatTheSpindleHasAlready) {
  const TemporaryFolder folder;
  Spindle weak{3000 * units::rad_per_s};
  weak.torque_limit = 0.02 * units::N_mm;
  Simulation simulation = soft_cut(weak);
  const StepStatus seen = record_and_repeat(
      simulation, 400,
      [&](int tick) {
        if (tick % 7 == 0) simulation.spindle().set_speed(simulation.spindle().setting());
      },
      folder / "a.h5");
  EXPECT_TRUE(has_any(seen, StepStatus::spindle_stalled));
}

// A halt of the motor before the tool was exchanged is none of the motor that is recorded.
TEST(Replay, KnowsOnlyTheMotorThatIsRecorded) {
  const TemporaryFolder folder;
  Spindle slow{3000 * units::rad_per_s};
  slow.acceleration_limit = 1e4;
  Simulation simulation = soft_cut(slow);
  simulation.spindle().halt();
  simulation.set(simulation.tool());
  (void)record_and_repeat(
      simulation, 100, [](int) {}, folder / "a.h5");
}

TEST(Replay, HasTheReservedBlocksOfTheRun) {
  const TemporaryFolder folder;
  SimulationConfig config;
  config.reserved_blocks = 2;
  Workpiece workpiece = test::plain_block();
  workpiece.reserve_blocks(3);  // more than the configuration asks for
  Simulation simulation(std::move(workpiece), Tool(SphereHead{1e-3}, RayHandle{0}, Spindle{3000 * units::rad_per_s}),
                        config);
  const StepStatus seen = record_and_repeat(
      simulation, 600,
      [&](int tick) {
        if (tick == 300) simulation.reserve_blocks(4), simulation.reserve_blocks(1);
      },
      folder / "a.h5");
  EXPECT_TRUE(has_any(seen, StepStatus::blocks_exhausted));
}

// Where voxels were emptied, the workpiece keeps their materials, and memory for fills even if no other voxel is partly
// filled. A file has neither, so a clone has neither: the run takes as many blocks from the reserve as its replay.
TEST(Replay, OfACutWorkpieceTakesTheBlocksThatTheRunTook) {
  const TemporaryFolder folder;
  SimulationConfig config;
  config.reserved_blocks = 100;
  Simulation simulation = soft_cut(Spindle{3000 * units::rad_per_s}, config);
  BlockVoxels corner;
  corner.voxels.add(0);
  for (const int x : {8, 16, 24})
    for (const int y : {8, 16, 24}) {
      corner.origin = {x, y, 16};
      ASSERT_EQ(simulation.workpiece().fill_at(corner.origin), 1);
      ASSERT_TRUE(simulation.remove_voxels(corner));
    }
  simulation.reset(simulation.workpiece().clone());
  const BlockView block = simulation.workpiece().block(corner.origin);
  EXPECT_EQ(block.fill, nullptr);
  ASSERT_NE(block.material, nullptr);
  EXPECT_EQ(block.material[0], kEmpty);
  (void)record_and_repeat(
      simulation, 500, [](int) {}, folder / "a.h5");
  EXPECT_LT(simulation.workpiece().reserved_blocks(), 100U);
}

/// A coupling that always gives the force of the model.
class Direct final : public HandCoupling {
 public:
  std::optional<HandOutput> answer(const StepResult& stepped) noexcept override {
    return HandOutput{at_depth(0), stepped.model, 1e-3};
  }
};

// A refused step of a coupling may place the tool again before it is refused.
TEST(Replay, KnowsThatARejectedStepWasThatOfACoupling) {
  const TemporaryFolder folder;
  Simulation simulation = soft_cut();
  const StepLog log(simulation);
  Recorder recorder(folder / "a.h5", simulation, patient());
  Direct coupling;
  StepStatus seen = StepStatus::ok;
  for (int tick = 0; tick < 300; ++tick) {
    Twist velocity = plunge(tick).V_WH;
    if (tick == 200) {  // after a release the tool comes from far away, so this step is a jump
      simulation.release_hand();
      velocity.linear.x() = 20;
    }
    seen |= simulation.step(plunge(tick).X_WH, velocity, 1e-3, &coupling).status;
  }
  recorder.close();
  EXPECT_TRUE(has_any(seen, StepStatus::jump_rejected));
  expect_repeats(folder / "a.h5", log);
}

TEST(Replay, IsIdenticalWhenTheWorkpieceChangesAfterTheLastStep) {
  const TemporaryFolder folder;
  const test::Scene& scene = test::find_scene("axial_flat");
  Simulation simulation = scene.make();
  simulation.history().reserve(1000);
  simulation.history().mark();
  Recorder recorder(folder / "a.h5", simulation, patient());
  for (int tick = 0; tick < 300; ++tick) recorder.step(scene.input(tick));
  ASSERT_GT(simulation.totals().removed_volume[1], 0);
  test::undo_all(simulation);
  recorder.close();
  const Recording recording = read_recording(folder / "a.h5");
  EXPECT_TRUE(recording.info().closed);
  EXPECT_FALSE(recording.info().workpiece_hash_at_end);
  EXPECT_TRUE(replay(recording).identical);
}

// Older recordings do not tell whether the spindle was held or set.
TEST(Replay, OfAnOlderRecordingDoesWithoutTheNewerColumns) {
  const TemporaryFolder folder;
  Simulation simulation = soft_cut();
  (void)record_and_repeat(
      simulation, 200,
      [&](int tick) {
        if (tick % 40 == 0) simulation.spindle().set_speed((1000 + 10 * tick) * units::rad_per_s);
        if (tick == 90) simulation.spindle().halt();
      },
      folder / "a.h5");
  {
    const hdf5::File file(H5Fopen((folder / "a.h5").c_str(), H5F_ACC_RDWR, H5P_DEFAULT), "opening");
    const hdf5::Group steps = hdf5::open_group(file.get(), "steps");
    std::string names = hdf5::read_text_attribute(steps.get(), "fields");
    for (const std::string name : {"spindle_set", "spindle_held"}) {
      const std::size_t at = names.find("," + name + ",");
      ASSERT_NE(at, std::string::npos) << names;
      names.erase(at, name.size() + 1);
      hdf5::checked(H5Ldelete(steps.get(), name.c_str(), H5P_DEFAULT), "deleting");
    }
    hdf5::checked(H5Adelete(steps.get(), "fields"), "deleting");
    hdf5::write_attribute(steps.get(), "fields", names);
  }
  const Recording recording = read_recording(folder / "a.h5");
  EXPECT_FALSE(recording.read(0, 1).at(0).spindle_held);
  EXPECT_TRUE(replay(recording).identical);
}

}  // namespace
}  // namespace hapticut::replay_test
