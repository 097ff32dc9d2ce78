// SPDX-License-Identifier: Apache-2.0
#include "hapticut/io/playback.hpp"

#include "hapticut/core/errors.hpp"
#include "hapticut/io/recording.hpp"

namespace hapticut {
namespace {

constexpr std::uint64_t kAtOnce = 4096;  // steps

/// The pose of the handle as a reading of a device whose base is the world.
DeviceState reading_of(const RecordedStep& step) {
  DeviceState state;
  state.X_BS = step.input.pose;
  state.velocity = step.input.velocity;
  state.time = step.time;
  state.sequence = step.number + 1;
  return state;
}

DeviceCapabilities of_poses() {
  DeviceCapabilities capabilities;
  capabilities.model = "poses of the handle";
  capabilities.output_degrees_of_freedom = 0;
  return capabilities;
}

}  // namespace

std::unique_ptr<PlaybackDevice> open_playback(const std::filesystem::path& path) {
  const Recording recording = read_recording(path);
  if (recording.size() == 0) throw Error("the recording '" + path.string() + "' has no steps to play back.");
  std::vector<DeviceState> readings;
  readings.reserve(recording.size());
  for (std::uint64_t first = 0; first < recording.size(); first += kAtOnce)
    for (const RecordedStep& step : recording.read(first, kAtOnce)) {
      const DeviceState reading = recording.has_device() ? step.device.state : reading_of(step);
      // Behind a coupling a fast tick makes several steps of one reading.
      if (!readings.empty() && readings.back().sequence == reading.sequence) continue;
      readings.push_back(reading);
    }
  return std::make_unique<PlaybackDevice>(
      std::move(readings), recording.has_device() ? recording.capabilities() : of_poses(), "replay:" + path.string());
}

void use_recordings() {
  register_device_driver(
      {"replay", "replay:FILE, FILE a recording", "", [](const std::string& rest) -> std::unique_ptr<Device> {
         if (rest.empty()) throw Error("The device \"replay\" needs the file of a recording: replay:FILE.");
         return open_playback(rest);
       }});
}

}  // namespace hapticut
