// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "hapticut/io/recording/recorder.hpp"
#include "hapticut/io/recording/recording.hpp"
#include "support/scenes.hpp"

/// @file
/// Recordings for tests.
namespace hapticut::test {

/// Waits for the disk, because nobody feels these steps.
inline RecorderOptions patient() {
  RecorderOptions options;
  options.wait_when_full = true;
  return options;
}

/// Records the first steps of a scene.
inline void record_scene(const std::filesystem::path& path, const std::string& scene_name, int steps,
                         const RecorderOptions& options = patient()) {
  const Scene& scene = find_scene(scene_name);
  Simulation simulation = scene.make();
  Recorder recorder(path, simulation, options);
  for (int tick = 0; tick < steps; ++tick) recorder.step(scene.input(tick));
  recorder.close();
}

}  // namespace hapticut::test
