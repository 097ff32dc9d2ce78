// SPDX-License-Identifier: Apache-2.0
#include "hapticut/device/simulated/playback.hpp"

#include <utility>

#include "hapticut/core/errors.hpp"

namespace hapticut {

PlaybackDevice::PlaybackDevice(std::vector<DeviceState> readings, const DeviceCapabilities& capabilities,
                               std::string name)
    : PolledDevice(std::move(name), capabilities), readings_(std::move(readings)) {
  if (readings_.empty()) throw Error("There is nothing to play back: the list of readings is empty.");
}

void PlaybackDevice::begin_run(const RunOptions& /*options*/) { next_ = 0; }

bool PlaybackDevice::read(DeviceState& state) noexcept {
  if (next_ >= readings_.size()) return false;
  state = readings_[next_++];
  return true;
}

Wrench PlaybackDevice::write(const Wrench& wrench) noexcept { return wrench; }  // nobody feels it

}  // namespace hapticut
