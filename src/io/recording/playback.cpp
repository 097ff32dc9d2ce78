// SPDX-License-Identifier: Apache-2.0
#include "hapticut/io/recording/playback.hpp"

#include <algorithm>
#include <string>

#include "device/usages.hpp"
#include "hapticut/core/errors.hpp"
#include "hapticut/io/recording/recording.hpp"
#include "io/recording/recording_file.hpp"

namespace hapticut {
namespace {

constexpr std::uint64_t kStepsAtOnce = 4096;  // steps

DeviceCapabilities of_poses() {
  DeviceCapabilities capabilities;
  capabilities.model = "poses of the handle";
  capabilities.output_degrees_of_freedom = 0;
  return capabilities;
}

}  // namespace

std::unique_ptr<PlaybackDevice> open_playback(const std::filesystem::path& path, const PlaybackRange& range) {
  const Recording recording = read_recording(path);
  const std::uint64_t size = recording.size(), begin = std::min(range.first, size);
  const std::uint64_t count = std::min(range.count, size - begin), end = begin + count;
  if (count == 0)
    throw Error("the recording '" + path.string() + "' has " + std::to_string(size) +
                " steps, but none to play back from number " + std::to_string(range.first) + " on.");
  if (count > kMaxPlayedSteps)
    throw Error("the recording '" + path.string() + "' has " + std::to_string(count) + " steps to play back; at most " +
                std::to_string(kMaxPlayedSteps) + " are kept in memory; record a shorter one" +
                Sentence::clause(", or open a part of it with a " + "PlaybackRange"_name) + ".");
  std::vector<DeviceState> readings;
  readings.reserve(count);
  for (std::uint64_t first = begin; first < end; first += kStepsAtOnce)
    for (const RecordedStep& step : recording.read(first, std::min(kStepsAtOnce, end - first))) {
      const DeviceState reading = recording.has_device() ? step.device.state : reading_of_handle(step);
      // With a coupling, a fast tick makes several steps from one reading. A repeated reading of a later tick has its
      // own time.
      if (!readings.empty() && readings.back().sequence == reading.sequence && readings.back().time == reading.time)
        continue;
      readings.push_back(reading);
    }
  return std::make_unique<PlaybackDevice>(
      std::move(readings), recording.has_device() ? recording.capabilities() : of_poses(), "replay:" + path.string());
}

void use_recordings() {
  register_device_driver({"replay", kReplayUsage, "", [](const std::string& rest) -> std::unique_ptr<Device> {
                            if (rest.empty())
                              throw Error("The device \"replay\" needs the file of a recording: replay:FILE.");
                            return open_playback(rest);
                          }});
}

}  // namespace hapticut
