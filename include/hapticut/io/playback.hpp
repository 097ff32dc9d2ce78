// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <memory>

#include "hapticut/device/playback.hpp"

namespace hapticut {

/// A device that plays a recording back: the readings of the device that was recorded, or, where there was none, the
/// poses of the handle in the world (then the base B is the world W, and there is no force).
/// @throws Error when the recording cannot be read, or is empty
[[nodiscard]] std::unique_ptr<PlaybackDevice> open_playback(const std::filesystem::path& recording);

/// Makes `open_device("replay:FILE")` work.
void use_recordings();

}  // namespace hapticut
