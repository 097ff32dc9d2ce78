// SPDX-License-Identifier: Apache-2.0
// Distances and first touches while a loop drives the simulation.
#include <gtest/gtest.h>

#include "experiments/setup/cutting.hpp"
#include "hapticut/device/simulated/mock.hpp"
#include "hapticut/loop/simulation_model.hpp"
#include "hapticut/workpiece/builders.hpp"
#include "support/scripted_loop.hpp"

namespace hapticut::loop_touch_test {
namespace {

constexpr double kRadius = 1.5e-3, kVoxel = 2e-4;  // [m] radius of the ball; voxel of the block

/// A block whose upper face the ball touches when the stylus is at the origin of its base.
Simulation block_under_the_ball() {
  SimulationConfig config;
  config.reference_stiffness = 1e13;
  return {build_block({Vec3(-14e-3, -14e-3, -8e-3), Vec3(14e-3, 14e-3, 0)}, kVoxel, test::plain_material()),
          Tool(SphereHead{kRadius}, RayHandle{0}, Spindle{3000 * units::rad_per_s}), config};
}

SimulationModelOptions ball_above_the_block() {
  SimulationModelOptions options;
  options.map.X_WB = Pose::from_translation(Vec3(0, 0, kRadius));
  return options;
}

RealtimeLoopOptions options_for(double seconds) {
  RealtimeLoopOptions options;
  options.run = test::scripted_loop::simulated_run();
  options.run.seconds = seconds;
  options.run.guard.arming.ramp = options.run.guard.arming.short_ramp = 0.05;
  return options;
}

/// Measures the distance from the first material in each step.
class Watch final : public StepObserver {
 public:
  void on_step(const ObservedStep& step) noexcept override {
    distance = step.simulation.distance_to(1, step.input.X_WH);
    is_touched = step.simulation.totals().touched.has(1);
    events += step.simulation.first_touched().has(1) ? 1 : 0;
    if (is_touched && nearest_before < 0) nearest_before = last;
    last = distance;
  }
  double distance = -1, last = -1, nearest_before = -1;  // [m]
  bool is_touched = false;
  int events = 0;
};

TEST(LoopTouch, IsInTheSnapshotAndAnObserverMeasuresTheDistance) {
  const auto device = test::scripted_loop::stiff_mock("press");
  Simulation simulation = block_under_the_ball();
  Watch watch;
  simulation.observers().add(watch);
  SimulationModel model(simulation, *device, ball_above_the_block());
  RealtimeLoop loop(*device, model, options_for(0.5));
  loop.start();
  (void)loop.wait();
  EXPECT_FALSE(loop.latest().tool.touched.has(1)) << "the hand is still above the block";
  EXPECT_EQ(watch.events, 0);
  EXPECT_GT(watch.distance, 0);

  RealtimeLoop longer(*device, model, options_for(3));
  longer.start();
  (void)longer.wait();
  EXPECT_TRUE(longer.latest().tool.touched.has(1));
  EXPECT_EQ(longer.latest().tool.touched.size(), 1);
  EXPECT_EQ(watch.events, 1);
  EXPECT_LT(watch.distance, kVoxel) << "within a voxel of what it cuts";
  EXPECT_LT(watch.nearest_before, 0.2 * kVoxel) << "it came near before it touched";
  simulation.observers().remove(watch);
}

}  // namespace
}  // namespace hapticut::loop_touch_test
