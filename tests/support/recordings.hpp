// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

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
