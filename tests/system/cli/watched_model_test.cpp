// SPDX-License-Identifier: Apache-2.0
// Data of the ticks of a model for a page.
#include "page/session/watched_model.hpp"

#include <gtest/gtest.h>

#include <numeric>

#include "support/scripted_loop.hpp"

namespace hapticut::watched_model_test {
namespace {

using apps::WatchedModel;

/// A ball that moves deeper into a block in each tick, and its recorded data.
struct Cut {
  test::scripted_loop::ScriptedLoop scripted{3000};
  WatchedModel watched{scripted.model, scripted.simulation, *scripted.device, 1e-3};
  std::vector<Vec3> forces;

  void run(int ticks) {
    RunOptions options;
    options.simulated_time = true;
    options.stop_on_signals = false;
    options.guard.arming.ramp = options.guard.arming.short_ramp = 0.02;
    (void)scripted.device->run(
        [&](const DeviceState& reading) {
          DeviceState state = reading;
          state.X_BS.translation.z() = 0.3e-3 - 1e-6 * double(forces.size());
          LoopSnapshot snapshot;
          DeviceCommand command{watched.step(state, 1e-3, snapshot), false, watched.contact()};
          forces.push_back(snapshot.tool.force);
          command.stop = --ticks == 0;
          return command;
        },
        options);
  }
};

TEST(WatchedModel, TellsTheForceOfEachTickOnce) {
  Cut cut;
  for (const int ticks : {450, 250}) {
    const std::size_t first = cut.forces.size();
    cut.run(ticks);
    const WatchedModel::Trace trace = cut.watched.drain_trace();
    EXPECT_EQ(trace.first, first);
    ASSERT_EQ(trace.samples.size(), std::size_t(ticks));
    for (std::size_t n = 0; n < trace.samples.size(); ++n)
      for (Eigen::Index axis = 0; axis < 3; ++axis)
        ASSERT_EQ(trace.samples[n].force[std::size_t(axis)], float(cut.forces[first + n][axis]));
  }
  EXPECT_TRUE(cut.watched.drain_trace().samples.empty());
  EXPECT_GT(cut.forces[449].norm(), 0);
  EXPECT_EQ(cut.forces.back().norm(), 0) << "the second run begins in the material, and the guard holds its force back";
}

TEST(WatchedModel, KeepsTheOldestTicksWhileNoneAreRead) {
  Cut cut;
  cut.run(int(WatchedModel::kTicks) + 10);
  const WatchedModel::Trace trace = cut.watched.drain_trace();
  EXPECT_EQ(trace.first, 0U);
  EXPECT_EQ(trace.samples.size(), WatchedModel::kTicks);
  cut.run(1);
  EXPECT_EQ(cut.watched.drain_trace().samples.size(), 1U);
}

TEST(WatchedModel, ReportsTicksTheirLatenessAndTheRemovedVolume) {
  Cut cut;
  cut.watched.begin_run();
  cut.run(600);
  view::Instruments shown;
  cut.watched.fill(shown, 1);
  EXPECT_EQ(shown.ticks, 600U);
  EXPECT_EQ(shown.bucket, WatchedModel::kBucket);
  EXPECT_EQ(std::accumulate(shown.latency.begin(), shown.latency.end(), 0U), 599U);  // the first tick has no lateness
  ASSERT_EQ(shown.removed.size(), 1U);
  EXPECT_GT(shown.removed[0], 0);
  EXPECT_EQ(shown.removed[0], cut.scripted.simulation.totals().removed_volume[1]);
}

TEST(WatchedModel, TellsTheMeanForceOnEachMaterialAndTheOneUnderTheTip) {
  Cut cut;
  cut.run(600);
  const std::vector<double> mean = cut.watched.drain_forces(1);
  ASSERT_EQ(mean.size(), 1U);
  EXPECT_GT(mean[0], 0);
  EXPECT_LT(mean[0], cut.scripted.simulation.normal_forces()[1]) << "it grew during the run";
  EXPECT_EQ(cut.watched.drain_forces(1)[0], 0) << "no tick since the last call";
  view::Instruments shown;
  cut.watched.fill(shown, 1);
  EXPECT_EQ(shown.under, 1);
}

TEST(WatchedModel, ReportsTheSettingsAfterCommands) {
  Cut cut;
  EXPECT_EQ(cut.watched.settings().spindle_speed, 3000);
  EXPECT_EQ(cut.watched.settings().answered, 0U);
  LoopCommand refused = commands::Undo{};  // there is no mark
  EXPECT_FALSE(cut.watched.apply(refused));
  EXPECT_EQ(cut.watched.settings().answered, 1U);
  Effects effects;
  effects.gravity = Gravity{.mass = 0.2};
  LoopCommand spindle = commands::SetSpindleSpeed{100 * units::rad_per_s}, gravity = commands::SetEffects{effects},
              removal = commands::SetRemoval{RemovalLaw::none};
  for (LoopCommand* command : {&spindle, &gravity, &removal}) EXPECT_TRUE(cut.watched.apply(*command));
  const apps::ModelSettings& has = cut.watched.settings();
  EXPECT_EQ(has.answered, 4U);
  EXPECT_EQ(has.spindle_speed, 100);
  EXPECT_EQ(has.effects.gravity->mass, 0.2);
  EXPECT_EQ(has.removal, RemovalLaw::none);
}

}  // namespace
}  // namespace hapticut::watched_model_test
