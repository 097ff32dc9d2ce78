// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <filesystem>
#include <limits>
#include <memory>

#include "hapticut/device/simulated/playback.hpp"

namespace hapticut {

/// [steps] that one playback holds in memory at most, 0.2 kB each: 2 h 46 min at 1 kHz, 1.9 GB.
inline constexpr std::uint64_t kMaxPlayedSteps = 10'000'000;

/// Which steps of a recording are played back. They are held in memory, so that the loop waits for no disk.
struct PlaybackRange {
  std::uint64_t first = 0;                                          ///< number of the first step
  std::uint64_t count = std::numeric_limits<std::uint64_t>::max();  ///< [steps] at most; all that there are
};

/// A device that plays a recording back: the readings of the device that was recorded, or, where there was none, the
/// poses of the handle in the world (then the base B is the world W, and there is no force).
/// @throws Error when the recording cannot be read, has no steps in the range, or more than kMaxPlayedSteps
[[nodiscard]] std::unique_ptr<PlaybackDevice> open_playback(const std::filesystem::path& recording,
                                                            const PlaybackRange& range = {});

/// Makes `open_device("replay:FILE")` work.
void use_recordings();

}  // namespace hapticut
