// SPDX-License-Identifier: Apache-2.0
// A recorder beside other observers, and what ends its recording.
#include <gtest/gtest.h>

#include "hapticut/io/recording/recorder.hpp"
#include "hapticut/io/recording/replay.hpp"
#include "support/recordings.hpp"
#include "support/temporary_folder.hpp"

namespace hapticut::recorder_among_observers_test {
namespace {

using test::patient;
using test::TemporaryFolder;

void step_in_the_air(Recorder& recorder, int steps) {
  for (int tick = 0; tick < steps; ++tick)
    recorder.step({Pose::from_translation(Vec3(0, 0, 1 + 1e-6 * tick)), {}, 1e-3});
}

TEST(Recorder, EndsWhenAPieceThatWasCutLooseLeavesAndWhatCameBeforeReplays) {
  const TemporaryFolder folder;
  Simulation simulation = find_scene("axial_flat").make();
  Recorder recorder(folder / "a.h5", simulation, patient());
  step_in_the_air(recorder, 10);
  BlockVoxels some;
  simulation.workpiece().for_each_block([&](const BlockView& block) { some.origin = block.origin; });
  some.voxels.words[0] = 0xff;
  ASSERT_TRUE(simulation.remove_voxels(some));
  step_in_the_air(recorder, 5);
  EXPECT_EQ(recorder.recorded(), 10U);
  EXPECT_EQ(recorder.lost(), 5U);
  recorder.close();
  const ReplayReport report = replay(read_recording(folder / "a.h5"));
  EXPECT_TRUE(report.identical);
  EXPECT_EQ(report.steps, 10U);
}

TEST(Recorder, IsOneOfTheObserversOfItsSimulation) {
  const TemporaryFolder folder;
  Simulation simulation = find_scene("axial_flat").make();
  {
    Recorder first(folder / "a.h5", simulation, patient()), second(folder / "b.h5", simulation, patient());
    step_in_the_air(first, 10);
    EXPECT_EQ(first.recorded(), 10U);
    EXPECT_EQ(second.recorded(), 10U);
  }
  EXPECT_TRUE(simulation.observers().empty());
}

}  // namespace
}  // namespace hapticut::recorder_among_observers_test
