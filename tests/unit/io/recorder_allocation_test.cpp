// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include "support/allocation_count.hpp"
#include "support/recordings.hpp"
#include "support/temporary_folder.hpp"

namespace hapticut::recorder_allocation_test {
namespace {

TEST(RecorderStep, AllocatesNothingAndTakesNoLock) {
  const test::TemporaryFolder folder;
  for (const std::size_t steps : {std::size_t(16), std::size_t(8192)}) {  // a buffer that overflows, and one with room
    const test::Scene& scene = test::find_scene("axial_flat");
    Simulation simulation = scene.make();
    RecorderOptions options;
    options.device = "a device";
    options.buffered_steps = steps;
    Recorder recorder(folder / "a.h5", simulation, options);
    const DeviceTick device;
    std::vector<StepInput> inputs;
    for (int tick = 0; tick < 500; ++tick) inputs.push_back(scene.input(tick));
    test::arm_call_counts();
    for (const StepInput& input : inputs) recorder.step(input, &device);
    const test::CallCounts counts = test::disarm_call_counts();
    EXPECT_EQ(counts.allocations, 0);
    EXPECT_EQ(counts.deallocations, 0);
    EXPECT_EQ(counts.locks, 0);
    EXPECT_EQ(recorder.recorded() + recorder.lost(), 500U);
    EXPECT_EQ(steps == 16, recorder.lost() > 0);
    recorder.close();
  }
}

}  // namespace
}  // namespace hapticut::recorder_allocation_test
