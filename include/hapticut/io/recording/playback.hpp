// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <filesystem>
#include <limits>
#include <memory>

#include "hapticut/device/simulated/playback.hpp"

namespace hapticut {

/// [steps] Limit of one playback, which is kept in memory: 0.2 kB per step, 1.9 GB for 2 h 46 min at 1 kHz.
inline constexpr std::uint64_t kMaxPlayedSteps = 10'000'000;

/// The steps of a recording to play back. They are kept in memory, so the loop never waits for a disk.
struct PlaybackRange {
  std::uint64_t first = 0;                                          ///< number of the first step
  std::uint64_t count = std::numeric_limits<std::uint64_t>::max();  ///< [steps] maximum number; default: all
};

/// Opens a device that plays back a recording. It plays the readings of the recorded device. A recording without a
/// device plays the poses of the handle: then the base B is the world W, and the device renders no force.
/// @throws Error when the recording cannot be read, or the range has no steps or more than kMaxPlayedSteps
[[nodiscard]] std::unique_ptr<PlaybackDevice> open_playback(const std::filesystem::path& recording,
                                                            const PlaybackRange& range = {});

/// Registers the device driver of `open_device("replay:FILE")`.
void use_recordings();

}  // namespace hapticut
