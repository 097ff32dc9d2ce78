// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <bit>
#include <cstdint>
#include <string>
#include <vector>

#include "hapticut/io/recording/recorder.hpp"
#include "hapticut/io/recording/recording.hpp"
#include "hapticut/io/recording/replay.hpp"
#include "support/refusal.hpp"
#include "support/scenes.hpp"

/// @file
/// Recordings for tests.
namespace hapticut::test {

/// Options that wait for the disk, because no hand feels these steps.
inline RecorderOptions patient() {
  RecorderOptions options;
  options.wait_when_full = true;
  return options;
}

/// Records the first steps of a scene.  @return the path
inline std::filesystem::path record_scene(const std::filesystem::path& path, const std::string& scene_name, int steps,
                                          const RecorderOptions& options = patient()) {
  const Scene& scene = find_scene(scene_name);
  Simulation simulation = scene.make();
  Recorder recorder(path, simulation, options);
  for (int tick = 0; tick < steps; ++tick) recorder.step(scene.input(tick));
  recorder.close();
  return path;
}

/// Steps in free air, which take almost no time.
inline void step_in_the_air(Recorder& recorder, int steps) {
  for (int tick = 0; tick < steps; ++tick)
    recorder.step({Pose::from_translation(Vec3(0, 0, 1 + 1e-6 * tick)), {}, 1e-3});
}

/// A number that differs when a bit of what a step gives differs: force, torque, removed voxels, volume, status.
inline std::uint64_t bits_of(const StepResult& result) {
  std::uint64_t hash = 0xcbf29ce484222325ULL;
  const auto mix = [&](std::uint64_t word) { hash = (hash ^ word) * 0x100000001b3ULL, hash ^= hash >> 29; };
  for (const Vec3& vector : {result.force, result.torque, result.model.force, result.model.torque})
    for (const double number : vector) mix(std::bit_cast<std::uint64_t>(number));
  for (const RemovedVoxel& voxel : result.removed_voxels) {
    for (const int i : voxel.index) mix(std::uint32_t(i));
    mix(voxel.material);
  }
  mix(std::bit_cast<std::uint64_t>(result.removed_volume));
  mix(std::uint64_t(result.status));
  return hash;
}

/// The bits of each step of a simulation, until something other than a step changes what a replay cannot repeat.
class StepLog final : public StepObserver {
 public:
  explicit StepLog(Simulation& simulation) : simulation_(simulation) { simulation.observers().add(*this); }
  ~StepLog() override { simulation_.observers().remove(*this); }
  StepLog(const StepLog&) = delete;
  StepLog& operator=(const StepLog&) = delete;

  void on_step(const ObservedStep& step) noexcept override {
    if (!ended_) bits_.push_back(bits_of(step.result));
  }
  void on_exchange() noexcept override { ended_ = true; }
  void on_removal(const BlockVoxels& /*removed*/) noexcept override { ended_ = true; }
  [[nodiscard]] const std::vector<std::uint64_t>& bits() const { return bits_; }

 private:
  Simulation& simulation_;
  std::vector<std::uint64_t> bits_;
  bool ended_ = false;
};

/// Expects a recording to hold the logged steps, and a replay to repeat them bit by bit.
inline void expect_repeats(const std::filesystem::path& path, const StepLog& log) {
  const Recording recording = read_recording(path);
  ASSERT_EQ(recording.size(), log.bits().size());
  std::uint64_t differing = 0;
  ReplayOptions options;
  options.on_step = [&](const Simulation& simulation, const RecordedStep& step) {
    if (bits_of(simulation.last_result()) != log.bits().at(step.number)) ++differing;
  };
  const ReplayReport report = replay(recording, options);
  EXPECT_EQ(report.steps, recording.size());
  EXPECT_EQ(differing, 0U) << "steps";
  ASSERT_TRUE(report.identical) << "step " << report.first_difference->step << " of " << report.steps << ", "
                                << report.first_difference->column << ": recorded " << report.first_difference->recorded
                                << ", replayed " << report.first_difference->replayed;
}

/// The message about a recording that cannot be replayed: one sentence that names the file. Empty if it can be
/// replayed.
inline std::string complaint_about(const std::filesystem::path& path) {
  const std::string text = refusal([&] { return replay(read_recording(path)); });
  if (text.empty()) return text;
  EXPECT_TRUE(text.starts_with("cannot read '" + path.string() + "': ")) << text;
  EXPECT_EQ(text.back(), '.') << text;
  EXPECT_EQ(text.find('\n'), std::string::npos) << text;
  return text;
}

}  // namespace hapticut::test
