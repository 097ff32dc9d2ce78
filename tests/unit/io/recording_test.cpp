// SPDX-License-Identifier: Apache-2.0
#include "hapticut/io/recording/recording.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <functional>
#include <limits>
#include <thread>

#include "experiments/setup/cutting.hpp"
#include "hapticut/core/build_info.hpp"
#include "hapticut/core/errors.hpp"
#include "hapticut/force/laws/contact_mechanics.hpp"
#include "hapticut/force/laws/foundation.hpp"
#include "hapticut/io/recording/replay.hpp"
#include "hapticut/io/vdb/vdb.hpp"
#include "hapticut/tool/catalogue.hpp"
#include "hapticut/workpiece/builders.hpp"
#include "io/recording/hdf5.hpp"
#include "support/recordings.hpp"
#include "support/temporary_folder.hpp"

namespace hapticut::recording_test {
namespace {

using test::patient;
using test::TemporaryFolder;

Simulation small_cut(const SimulationConfig& config = {},
                     const Tool& tool = Tool(SphereHead{1e-3}, RayHandle{20e-3}, Spindle{3000 * units::rad_per_s})) {
  return {build_block({Vec3(-2e-3, -2e-3, -3e-3), Vec3(2e-3, 2e-3, 0)}, 1e-4, test::plain_material()), tool, config};
}

/// Straight down at 2 mm/s from just above the face.
StepInput plunge(const Simulation& simulation, int tick) {
  const HeadBox box = simulation.tool().head().bounding_box();
  const double z = -box.min.z() + 1e-5 - 2e-6 * tick;
  const Pose pose = Pose::from_translation(Vec3(2.3e-5, 1.1e-5, z)) * simulation.tool().X_HT().inverse();
  return {pose, {Vec3(0, 0, -2e-3), Vec3::Zero()}, 1e-3};
}

/// Records a plunge from its beginning.
void record_plunge(const std::filesystem::path& path, Simulation& simulation, int steps,
                   const RecorderOptions& options = patient()) {
  Recorder recorder(path, simulation, options);
  for (int tick = 0; tick < steps; ++tick) recorder.step(plunge(simulation, tick));
  recorder.close();
}

ReplayReport replay_file(const std::filesystem::path& path) { return replay(read_recording(path)); }

void expect_identical(const ReplayReport& report, std::uint64_t steps, const std::string& what) {
  EXPECT_TRUE(report.identical) << what << ": step " << (report.first_difference ? report.first_difference->step : 0)
                                << ", " << (report.first_difference ? report.first_difference->column : "");
  EXPECT_EQ(report.steps, steps) << what;
  EXPECT_EQ(report.max_force_difference, 0) << what;
}

TEST(Recording, ReplaysEverySceneWithTheSameBits) {
  const TemporaryFolder folder;
  for (const test::Scene& scene : test::scenes()) {
    const Recording recording = read_recording(test::record_scene(folder / "scene.h5", scene.name, 700));
    EXPECT_TRUE(recording.info().closed);
    EXPECT_TRUE(recording.info().remarks.empty());
    expect_identical(replay(recording), 700, scene.name);
  }
}

TEST(Recording, HoldsTheResultsOfTheSteps) {
  const TemporaryFolder folder;
  Simulation simulation = small_cut();
  RecorderOptions options = patient();
  options.note = "a note";
  Recorder recorder(folder / "a.h5", simulation, options);
  std::vector<Vec3> forces, torques;
  std::vector<std::uint64_t> removed;
  std::vector<double> work;
  for (int tick = 0; tick < 300; ++tick) {
    const StepResult& result = recorder.step(plunge(simulation, tick));
    forces.push_back(result.force);
    torques.push_back(result.torque);
    removed.push_back(result.removed_voxels.size());
    work.push_back(result.energy.motor_work);
  }
  EXPECT_EQ(recorder.recorded(), 300U);
  EXPECT_EQ(recorder.lost(), 0U);
  recorder.close();

  const Recording recording = read_recording(folder / "a.h5");
  EXPECT_EQ(recording.info().note, "a note");
  EXPECT_EQ(recording.info().version, build_info().version);
  EXPECT_EQ(recording.info().workpiece_hash_at_end, simulation.workpiece().hash());
  EXPECT_FALSE(recording.has_device());
  ASSERT_EQ(recording.size(), 300U);
  const std::vector<RecordedStep> steps = recording.read(0, 1000);
  ASSERT_EQ(steps.size(), 300U);
  for (std::size_t n = 0; n < steps.size(); ++n) {
    const StepInput input = plunge(simulation, int(n));
    EXPECT_EQ(steps[n].number, n);
    EXPECT_NEAR(steps[n].time, 1e-3 * double(n + 1), 1e-12);
    EXPECT_EQ(steps[n].input.X_WH.translation, input.X_WH.translation);
    EXPECT_EQ(steps[n].input.X_WH.rotation, input.X_WH.rotation);
    EXPECT_EQ(steps[n].input.V_WH.linear, input.V_WH.linear);
    EXPECT_EQ(steps[n].force, forces[n]);
    EXPECT_EQ(steps[n].torque, torques[n]);
    EXPECT_EQ(steps[n].removed_voxels, removed[n]);
    EXPECT_EQ(steps[n].energy.motor_work, work[n]);
  }
  EXPECT_EQ(recording.read(298, 10).size(), 2U);
  EXPECT_EQ(recording.read(298, 10)[1].force, forces[299]);
  EXPECT_TRUE(recording.read(300, 10).empty());
}

TEST(Recording, ReplaysSettingsBetweenStepsAndRejectedSteps) {
  const TemporaryFolder folder;
  SimulationConfig config;
  config.reserved_blocks = 2;  // soon used up
  config.friction = DryFriction{0.4, 0.2, 500};
  config.effects.vibration.emplace();
  Simulation simulation = small_cut(config);
  simulation.spindle().set_speed(2500 * units::rad_per_s);
  Recorder recorder(folder / "a.h5", simulation, patient());
  StepStatus seen = StepStatus::ok;
  for (int tick = 0; tick < 600; ++tick) {
    if (tick == 100) simulation.spindle().set_speed(0);
    if (tick == 150) simulation.spindle().set_speed(-4000 * units::rad_per_s);
    if (tick == 200) {
      Effects effects;
      effects.gravity = Gravity{0.1, Vec3(0, 0, 0.01), Vec3(0, 0, -9.81)};
      effects.delta_filter.emplace();
      effects.enabled.torque[1] = false;
      effects.limits.max_force = 2;
      effects.limits.ramp_time = 0.1;
      simulation.set(effects);
    }
    if (tick == 250) simulation.set(Effects{});
    if (tick % 40 == 0) simulation.reserve_blocks(simulation.config().reserved_blocks + std::size_t(tick / 400));
    StepInput input = plunge(simulation, tick);
    if (tick == 300) input.X_WH.translation.x() = std::numeric_limits<double>::quiet_NaN();
    if (tick == 310) input.V_WH.angular.y() = std::numeric_limits<double>::infinity();
    if (tick == 320) input.dt = -1;
    if (tick == 330) input.X_WH.translation.x() += 1;
    seen |= recorder.step(input).status;
  }
  recorder.close();
  for (const StepStatus bit : {StepStatus::pose_rejected, StepStatus::velocity_rejected, StepStatus::dt_rejected,
                               StepStatus::jump_rejected, StepStatus::blocks_low})
    EXPECT_TRUE(has_any(seen, bit)) << std::uint32_t(bit);
  const Recording recording = read_recording(folder / "a.h5");
  ASSERT_EQ(recording.effects().size(), 3U);
  EXPECT_EQ(recording.effects()[1].first_step, 200U);
  EXPECT_EQ(recording.effects()[2].first_step, 250U);
  EXPECT_FALSE(recording.effects()[1].effects.enabled.torque[1]);
  EXPECT_TRUE(recording.effects()[1].effects.gravity && !recording.effects()[1].effects.vibration);
  EXPECT_TRUE(std::isinf(recording.effects()[1].effects.limits.max_torque));
  expect_identical(replay(recording), 600, "settings");
}

TEST(Recording, KeepsEveryKindOfToolAndSetting) {
  const TemporaryFolder folder;
  const LHandle angled{80e-3, 12e-3, 1.2};
  Spindle air_turbine{30000 * units::rad_per_s, 20, 1e5, 2e4};
  SimulationConfig config;
  config.removal = RemovalLaw::elastic_release;
  config.quadrature = Quadrature::sub_voxel;
  config.contact_time = ContactTime::end;
  config.handle_torque = HandleTorque::thesis;
  config.handle_torque_scale = 0.7;
  config.reference_stiffness = 3e13;
  config.deep_contact = false;
  config.voxel_budget = 5000;
  config.max_sweep = 77;
  config.removed_voxel_capacity = 20;
  for (const Tool& tool : {Tool(ConeHead{0.5, 3e-3}), Tool(FlatHead{1e-3, 2e-3, FlatRule::both}, angled, air_turbine),
                           Tool(round_head(2e-3), RayHandle{5e-3}, Spindle{-2000 * units::rad_per_s}),
                           Tool(pear_head(2e-3, 4e-3, 1e-3), angled, air_turbine)}) {
    Simulation simulation = small_cut(config, tool);
    Material material = test::plain_material();
    material.cutter = CutterKind::twist_drill;  // no tool has this kind, which the status reports
    simulation.set(MaterialTable({material}));
    record_plunge(folder / "a.h5", simulation, 200);
    const Recording recording = read_recording(folder / "a.h5");
    EXPECT_EQ(recording.tool().head().shape().index(), tool.head().shape().index());
    EXPECT_EQ(recording.tool().head().volume(), tool.head().volume());
    EXPECT_EQ(recording.tool().X_HT().translation, tool.X_HT().translation);
    EXPECT_EQ(recording.tool().spindle().droop, tool.spindle().droop);
    EXPECT_EQ(recording.config().max_sweep, 77);
    EXPECT_EQ(recording.config().voxel_budget, 5000U);
    EXPECT_EQ(recording.config().handle_torque, HandleTorque::thesis);
    EXPECT_FALSE(recording.config().friction);
    expect_identical(replay(recording), 200, "head " + std::to_string(tool.head().shape().index()));
  }
}

TEST(Recording, SaysWhereAReplayLeavesIt) {
  const TemporaryFolder folder;
  const Recording recording = read_recording(test::record_scene(folder / "a.h5", "axial_flat", 200));
  ASSERT_TRUE(recording.default_law());
  // Another law gives other forces from the first contact on.
  const ReplayReport report = replay(recording, {std::make_shared<ContactMechanicsLaw>(1e9), {}, {}});
  EXPECT_FALSE(report.identical);
  ASSERT_TRUE(report.first_difference);
  // Parts of voxels are touched slightly before or after their centroids.
  const std::vector<RecordedStep> steps = recording.read(report.first_difference->step, 50);
  EXPECT_GT(steps.back().contact.voxels, 0);
  EXPECT_GT(report.max_force_difference, 0);
  EXPECT_NE(report.first_difference->recorded, report.first_difference->replayed);
}

TEST(Recording, OfACustomLawNeedsThatLaw) {
  const TemporaryFolder folder;
  SimulationConfig config;
  config.law = std::make_shared<ContactMechanicsLaw>(1e9);
  Simulation simulation = small_cut(config);
  record_plunge(folder / "a.h5", simulation, 100);
  const Recording recording = read_recording(folder / "a.h5");
  EXPECT_THROW((void)replay(recording), Error);
  expect_identical(replay(recording, {config.law, {}, {}}), 100, "own law");
}

TEST(Recording, MayNameTheFileOfItsWorkpieceInsteadOfHoldingIt) {
  const TemporaryFolder folder;
  save_vdb(build_sphere(Vec3(0, 0, -2e-3), 2e-3, 1e-4, test::plain_material()), folder / "ball.vdb");
  Simulation simulation(load_vdb(folder / "ball.vdb"),
                        Tool(SphereHead{1e-3}, RayHandle{0}, Spindle{3000 * units::rad_per_s}));
  RecorderOptions options = patient();
  options.workpiece_file = folder / "ball.vdb";
  record_plunge(folder / "a.h5", simulation, 300, options);
  expect_identical(replay_file(folder / "a.h5"), 300, "file");

  // Both files moved to another folder.
  std::filesystem::create_directory(folder / "moved");
  for (const char* name : {"a.h5", "ball.vdb"}) std::filesystem::rename(folder / name, folder / "moved" / name);
  expect_identical(replay_file(folder / "moved/a.h5"), 300, "moved");

  save_vdb(build_sphere(Vec3(0, 0, -2e-3), 2.1e-3, 1e-4, test::plain_material()), folder / "moved/ball.vdb");
  EXPECT_THROW((void)replay_file(folder / "moved/a.h5"), Error);
  std::filesystem::remove(folder / "moved/ball.vdb");
  EXPECT_THROW((void)replay_file(folder / "moved/a.h5"), Error);
}

TEST(Recording, CanBeMadeOfACutWorkpieceAfterAReset) {
  const TemporaryFolder folder;
  Simulation simulation = small_cut();
  for (int tick = 0; tick < 300; ++tick) {
    const StepInput input = plunge(simulation, tick);
    simulation.step(input.X_WH, input.V_WH, input.dt);
  }
  EXPECT_THROW(Recorder(folder / "a.h5", simulation), Error);
  EXPECT_EQ(folder.file_count(), 0U);
  simulation.reset(simulation.workpiece().clone());
  Recorder recorder(folder / "a.h5", simulation, patient());
  for (int tick = 250; tick < 500; ++tick) recorder.step(plunge(simulation, tick));
  recorder.close();
  expect_identical(replay_file(folder / "a.h5"), 250, "cut before");
}

TEST(Recording, IsReadWhileItIsBeingWritten) {
  const TemporaryFolder folder;
  Simulation simulation = small_cut();
  Recorder recorder(folder / "a.h5", simulation, patient());
  for (int tick = 0; tick < 100; ++tick) recorder.step(plunge(simulation, tick));
  std::uint64_t size = 0;
  for (int attempt = 0; attempt < 2000 && size < 100; ++attempt) {
    const Recording recording = read_recording(folder / "a.h5");
    EXPECT_FALSE(recording.info().closed);
    EXPECT_EQ(recording.info().remarks.size(), 1U);
    size = recording.size();
    for (const RecordedStep& step : recording.read(0, size)) EXPECT_LT(step.number, 100U);
    std::this_thread::sleep_for(std::chrono::milliseconds(5));
  }
  EXPECT_EQ(size, 100U);
  recorder.close();
}

template <class Part>
void expect_same_fields(const Part& a, const Part& b) {
  for_each_field<Part>([&](const auto& field) { EXPECT_EQ(a.*field.member, b.*field.member) << field.name; });
}

TEST(Effects, SurviveTheWayThroughNumbers) {
  const TemporaryFolder folder;
  SimulationConfig config;
  config.effects.gravity = Gravity{0.2, Vec3(1e-3, 2e-3, 3e-3), Vec3(0, -9.8, 0)};
  config.effects.vibration = Vibration{120, 0.2, 0.01, 0.4};
  config.effects.delta_filter = DeltaFilter{0.3, 0.004};
  config.effects.enabled = {{true, false, true}, {false, true, false}};
  config.effects.limits = {5, 0.1, 900, 20, 0.5};
  Simulation simulation = small_cut(config);
  Recorder(folder / "a.h5", simulation, patient()).close();
  const Effects &before = config.effects, after = read_recording(folder / "a.h5").config().effects;
  expect_same_fields(*after.gravity, *before.gravity);
  expect_same_fields(*after.vibration, *before.vibration);
  expect_same_fields(*after.delta_filter, *before.delta_filter);
  expect_same_fields(after.enabled, before.enabled);
  expect_same_fields(after.limits, before.limits);
}

TEST(Recording, HoldsHowManyTurnsAVoxelBudgetTakes) {
  const TemporaryFolder folder;
  SimulationConfig config;
  config.voxel_budget = 4096;
  Simulation simulation(build_block({Vec3(-2e-3, -2e-3, -2e-3), Vec3(2e-3, 2e-3, 0)}, 5e-5, test::plain_material()),
                        Tool(SphereHead{1e-3}, RayHandle{20e-3}), config);  // presses on more and more voxels
  Recorder recorder(folder / "a.h5", simulation, patient());
  std::vector<int> levels;
  for (int tick = 0; tick < 300; ++tick)
    levels.push_back(recorder.step(plunge(simulation, tick)).contact.level_of_detail);
  recorder.close();
  ASSERT_GT(*std::max_element(levels.begin(), levels.end()), 1);
  const std::vector<RecordedStep> steps = read_recording(folder / "a.h5").read(0, 300);
  for (const RecordedStep& step : steps) EXPECT_EQ(step.contact.level_of_detail, levels.at(step.number)) << step.number;
  expect_identical(replay_file(folder / "a.h5"), 300, "in turns");
}

// A recording has all results of a step: each field of StepResult, or each of its subfields, is a column.
TEST(Recording, HasAColumnForEachFieldOfAResult) {
  const TemporaryFolder folder;
  test::record_scene(folder / "a.h5", "axial_flat", 2);
  const hdf5::File file(H5Fopen((folder / "a.h5").c_str(), H5F_ACC_RDONLY, H5P_DEFAULT), "opening");
  const hdf5::Group group = hdf5::open_group(file.get(), "steps");
  for_each_field<StepResult>([&](const auto& field) {
    using Type = typename std::remove_cvref_t<decltype(field)>::Type;
    const std::string name = field.name;
    if constexpr (Described<Type>)
      for_each_field<Type>([&](const auto& part) {
        EXPECT_TRUE(hdf5::exists(group.get(), name + "_" + part.name)) << name << " " << part.name;
      });
    else if constexpr (std::is_same_v<Type, Wrench>)
      EXPECT_TRUE(hdf5::exists(group.get(), name + "_force") && hdf5::exists(group.get(), name + "_torque")) << name;
    else
      EXPECT_TRUE(hdf5::exists(group.get(), name)) << name;
  });
}

}  // namespace
}  // namespace hapticut::recording_test
