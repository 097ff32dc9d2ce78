// SPDX-License-Identifier: Apache-2.0
#include "hapticut/io/recording/playback.hpp"

#include <gtest/gtest.h>

#include "hapticut/core/errors.hpp"
#include "hapticut/device/simulated/mock.hpp"
#include "support/recordings.hpp"
#include "support/temporary_folder.hpp"

namespace hapticut::playback_test {
namespace {

using test::TemporaryFolder;

RunOptions in_simulated_time() {
  RunOptions options;
  options.simulated_time = true;
  options.stop_on_signals = false;
  return options;
}

bool same(const DeviceState& a, const DeviceState& b) {
  return a.X_BS.rotation == b.X_BS.rotation && a.X_BS.translation == b.X_BS.translation &&
         a.velocity.linear == b.velocity.linear && a.velocity.angular == b.velocity.angular && a.buttons == b.buttons &&
         a.time == b.time && a.sequence == b.sequence && a.epoch == b.epoch && a.temperature == b.temperature &&
         a.valid == b.valid && a.fault == b.fault;
}

/// All readings of a playback device.
std::vector<DeviceState> readings_of(PlaybackDevice& playback) {
  std::vector<DeviceState> readings;
  (void)playback.run(
      [&](const DeviceState& state) {
        readings.push_back(state);
        return DeviceCommand{};
      },
      in_simulated_time());
  return readings;
}

TEST(Playback, GivesTheReadingsOfARecordedDeviceAgain) {
  const TemporaryFolder folder;
  const auto device = open_device("mock:spiral,seconds=3,hand=nominal");
  Simulation simulation = test::find_scene("axial_flat").make();
  RecorderOptions options = test::patient();
  options.device = device->name();
  options.capabilities = device->capabilities();
  Recorder recorder(folder / "a.h5", simulation, options);
  std::vector<DeviceState> states;
  std::vector<Wrench> forces;
  RunOptions run = in_simulated_time();
  const auto callback = [&](Recorder* keeper) {
    return [&, keeper](const DeviceState& state) {
      states.push_back(state);
      const DeviceTick tick{state, {}, ArmingState::on};
      const StepInput input{Pose::from_translation(state.X_BS.translation + Vec3(0, 0, 20e-3)), state.velocity, 1e-3};
      if (keeper != nullptr) keeper->step(input, &tick);
      return DeviceCommand{{Vec3(0, 0, state.X_BS.translation.z() < 0 ? 0.5 : 0), Vec3::Zero()}, false};
    };
  };
  (void)device->run(callback(&recorder), run);
  recorder.close();
  const std::vector<DeviceState> recorded = std::exchange(states, {});
  ASSERT_EQ(recorded.size(), 3000U);

  use_recordings();
  const auto playback = open_device("replay:" + (folder / "a.h5").string());
  EXPECT_EQ(playback->capabilities().model, device->capabilities().model);
  EXPECT_EQ(playback->capabilities().peak_force, device->capabilities().peak_force);
  EXPECT_EQ(playback->capabilities().workspace_high, device->capabilities().workspace_high);
  for (int again = 0; again < 2; ++again) {
    states.clear();
    const RunReport report = playback->run(callback(nullptr), run);
    EXPECT_EQ(report.end, "the device has no more readings");
    ASSERT_EQ(states.size(), recorded.size());
    for (std::size_t n = 0; n < states.size(); ++n) ASSERT_TRUE(same(states[n], recorded[n])) << n;
  }
}

// Regression: playback gave only one reading, because all recorded readings were equal.
TEST(Playback, OfADeviceThatWasOnlyNamedGivesThePosesOfTheHandle) {
  const TemporaryFolder folder;
  Simulation simulation = test::find_scene("axial_flat").make();
  RecorderOptions options = test::patient();
  options.device = "a device";
  Recorder recorder(folder / "a.h5", simulation, options);
  const auto pose_at = [](int n) { return Pose::from_translation(Vec3(1e-5 * n, 0, 50e-3)); };
  for (int n = 0; n < 20; ++n) simulation.step(pose_at(n), {}, 1e-3);
  recorder.close();
  const std::vector<DeviceState> readings = readings_of(*open_playback(folder / "a.h5"));
  ASSERT_EQ(readings.size(), 20U);
  for (int n = 0; n < 20; ++n) {
    EXPECT_EQ(readings[std::size_t(n)].X_BS.translation, pose_at(n).translation) << n;
    EXPECT_NEAR(readings[std::size_t(n)].time, 1e-3 * (n + 1), 1e-12);
  }
}

TEST(Playback, RepeatsAReadingThatCameAgainButNotTheSubTicks) {
  const TemporaryFolder folder;
  Simulation simulation = test::find_scene("axial_flat").make();
  RecorderOptions options = test::patient();
  options.device = "a device";
  options.capabilities.model = "of the tests";
  Recorder recorder(folder / "a.h5", simulation, options);
  const StepInput in_the_air{Pose::from_translation(Vec3(0, 0, 50e-3)), {}, 1e-3};
  DeviceTick tick;
  const auto record = [&](double time, std::uint64_t sequence) {
    tick.state.time = time;
    tick.state.sequence = sequence;
    recorder.step(in_the_air, &tick);
  };
  record(0.001, 1);
  record(0.002, 2);
  for (int part = 0; part < 3; ++part) record(0.003, 3);  // a fast tick with a coupling
  record(0.004, 3);                                       // the driver repeats its reading
  record(0.005, 3);
  record(0.006, 4);
  recorder.close();
  const auto playback = open_playback(folder / "a.h5");
  std::vector<double> times;
  const RunReport report = playback->run(
      [&](const DeviceState& state) {
        times.push_back(state.time);
        return DeviceCommand{};
      },
      in_simulated_time());
  EXPECT_EQ(times, (std::vector<double>{0.001, 0.002, 0.003, 0.006}));
  EXPECT_EQ(report.ticks, 6U);
  EXPECT_EQ(report.events[std::size_t(SafetyEvent::reading_stale)], 2U)
      << "the guard sees the stale readings of the recorded run";
}

TEST(Playback, PlaysAPartOfARecording) {
  const TemporaryFolder folder;
  test::record_scene(folder / "a.h5", "axial_flat", 200);
  EXPECT_EQ(open_playback(folder / "a.h5", {50, 20})->size(), 20U);
  EXPECT_EQ(open_playback(folder / "a.h5", {150})->size(), 50U);
  EXPECT_EQ(open_playback(folder / "a.h5", {150, 1000})->size(), 50U);
  EXPECT_THROW((void)open_playback(folder / "a.h5", {200}), Error);
  EXPECT_THROW((void)open_playback(folder / "a.h5", {0, 0}), Error);
  EXPECT_EQ(readings_of(*open_playback(folder / "a.h5", {50, 1})).at(0).X_BS.translation.z(),
            test::find_scene("axial_flat").input(50).X_WH.translation.z());
}

TEST(Playback, OfARecordingWithoutADeviceGivesThePosesOfTheHandle) {
  const TemporaryFolder folder;
  test::record_scene(folder / "a.h5", "axial_flat", 200);
  const auto playback = open_playback(folder / "a.h5");
  EXPECT_EQ(playback->size(), 200U);
  EXPECT_EQ(playback->capabilities().output_degrees_of_freedom, 0);
  const std::vector<DeviceState> readings = readings_of(*playback);
  ASSERT_EQ(readings.size(), 200U);
  for (int tick = 0; tick < 200; ++tick) {
    EXPECT_TRUE(readings[std::size_t(tick)].valid);
    EXPECT_EQ(readings[std::size_t(tick)].X_BS.translation,
              test::find_scene("axial_flat").input(tick).X_WH.translation);
  }
}

TEST(Playback, NeedsARecordingWithSteps) {
  const TemporaryFolder folder;
  use_recordings();
  EXPECT_THROW((void)open_device("replay"), Error);
  EXPECT_THROW((void)open_device("replay:" + (folder / "absent.h5").string()), Error);
  test::record_scene(folder / "empty.h5", "axial_flat", 0);
  EXPECT_THROW((void)open_playback(folder / "empty.h5"), Error);
  EXPECT_THROW(PlaybackDevice({}, {}), Error);
}

}  // namespace
}  // namespace hapticut::playback_test
