// SPDX-License-Identifier: Apache-2.0
// Two recorders of one file: the second is refused. A recording begins with a fresh simulation.
#include <gtest/gtest.h>

#include <filesystem>
#include <vector>

#include "hapticut/core/errors.hpp"
#include "io/atomic_file.hpp"
#include "support/recordings.hpp"
#include "support/temporary_folder.hpp"

namespace hapticut::second_recorder_test {
namespace {

using test::patient;
using test::step_in_the_air;
using test::TemporaryFolder;

Simulation some_simulation() { return test::find_scene("axial_flat").make(); }

/// A recording of some steps.
void record(const std::filesystem::path& path, int steps) {
  Simulation simulation = some_simulation();
  Recorder recorder(path, simulation, patient());
  step_in_the_air(recorder, steps);
  recorder.close();
}

/// Records to a file while others try to, under each of its names.
void record_alone(const std::filesystem::path& path, const std::vector<std::filesystem::path>& names) {
  Simulation simulation = some_simulation(), other = some_simulation();
  Recorder recorder(path, simulation, patient());
  step_in_the_air(recorder, 10);
  for (const auto& name : names) {
    const std::string refusal = test::refusal([&] { Recorder(name, other, patient()); });
    for (const char* part : {"cannot write the recording", "a.h5'", "still writing", "another file"})
      test::expect_part(refusal, part);
    EXPECT_TRUE(other.observers().all().empty());
  }
  step_in_the_air(recorder, 10);
  recorder.close();
  EXPECT_EQ(read_recording(path).size(), 20U);
  EXPECT_TRUE(read_recording(path).info().closed);
}

TEST(SecondRecorder, OfAFileIsRefusedUnderEachOfItsNames) {
  const TemporaryFolder folder;
  const std::filesystem::path path = folder / "a.h5";
  std::filesystem::create_directory_symlink(folder / "", folder / "link");
  std::filesystem::create_symlink(path, folder / "also-a.h5");
  const std::vector<std::filesystem::path> names = {path, folder / "./link/a.h5", folder / "also-a.h5",
                                                    std::filesystem::relative(path)};
  record_alone(path, names);  // writes a new file
  record_alone(path, names);  // beside an older recording
  EXPECT_EQ(folder.file_count(), 3U);
}

TEST(SecondRecorder, IsRefusedWhenTheOlderRecordingIsRemovedMeanwhile) {
  const TemporaryFolder folder;
  record(folder / "a.h5", 5);
  Simulation simulation = some_simulation(), other = some_simulation();
  Recorder recorder(folder / "a.h5", simulation, patient());
  std::filesystem::remove(folder / "a.h5");
  EXPECT_THROW(Recorder(folder / "a.h5", other), Error);
  step_in_the_air(recorder, 7);
  recorder.close();
  EXPECT_EQ(read_recording(folder / "a.h5").size(), 7U);
}

TEST(SecondRecorder, MayBeginWhenTheFirstIsDestroyedOrFails) {
  const TemporaryFolder folder;
  {
    Simulation simulation = some_simulation();
    Recorder recorder(folder / "a.h5", simulation, patient());
    step_in_the_air(recorder, 5);
  }
  record(folder / "a.h5", 6);  // writes a.h5.new
  {
    Simulation simulation = some_simulation();
    Recorder left(folder / "a.h5", simulation, patient());  // leaves a.h5.new
    step_in_the_air(left, 1);                               // without a step it is removed
  }
  EXPECT_EQ(folder.file_count(), 2U);
  record(folder / "a.h5", 7);
  EXPECT_EQ(read_recording(folder / "a.h5").size(), 7U);
  EXPECT_EQ(folder.file_count(), 1U);
}

TEST(SecondRecorder, OtherOutputsDoNotReplaceAGrowingRecordingEither) {
  const TemporaryFolder folder;
  Simulation simulation = some_simulation();
  Recorder recorder(folder / "a.h5", simulation, patient());
  step_in_the_air(recorder, 10);
  test::expect_part(test::refusal([&] { write_atomically(folder / "a.h5", "{}"); }), "still writing");
  recorder.close();
  EXPECT_EQ(read_recording(folder / "a.h5").size(), 10U);
  write_atomically(folder / "a.h5", "{}");
  EXPECT_EQ(test::read_bytes(folder / "a.h5"), "{}");
}

// What a replay cannot know: the material that the tool was in, and what was removed and not cut.
TEST(Recorder, NeedsAFreshSimulationAndACloneMakesOne) {
  const TemporaryFolder folder;
  const test::Scene& scene = test::find_scene("axial_flat");
  BlockVoxels some;
  some.voxels.words[0] = 0xff;
  for (const bool removes : {true, false}) {
    Simulation simulation = scene.make();
    simulation.workpiece().for_each_block([&](const BlockView& block) { some.origin = block.origin; });
    if (removes) {
      ASSERT_TRUE(simulation.remove_voxels(some));
    } else {
      for (int tick = 0; tick < 200; ++tick) simulation.step(scene.input(tick).X_WH, {}, 1e-3);
      Simulation other = scene.make();
      simulation.exchange(other);
      ASSERT_EQ(simulation.steps(), 0U);
    }
    EXPECT_FALSE(simulation.is_fresh());
    test::expect_part(test::refusal([&] { Recorder(folder / "a.h5", simulation); }), "clone of its workpiece");
    simulation.reset(simulation.workpiece().clone());
    EXPECT_TRUE(simulation.is_fresh());
    Recorder recorder(folder / "a.h5", simulation, patient());
    for (int tick = 0; tick < 300; ++tick) recorder.step(scene.input(tick));
    recorder.close();
    EXPECT_TRUE(replay(read_recording(folder / "a.h5")).identical);
  }
}

}  // namespace
}  // namespace hapticut::second_recorder_test
