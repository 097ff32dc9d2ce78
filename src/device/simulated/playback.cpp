// SPDX-License-Identifier: Apache-2.0
#include "hapticut/device/simulated/playback.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "hapticut/core/errors.hpp"

namespace hapticut {

PlaybackDevice::PlaybackDevice(std::vector<DeviceState> readings, const DeviceCapabilities& capabilities,
                               std::string name)
    : PolledDevice(std::move(name), capabilities), readings_(std::move(readings)) {
  if (readings_.empty()) throw Error("There is nothing to play back, because the list of readings is empty.");
}

/// The median period of the readings, if it differs from the requested period by more than the error of a clock.
double PlaybackDevice::choose_period(double asked) {
  constexpr double kInexact = 0.02, kMinStep = 1e-5, kMaxStep = 0.1;  // [1], [s], [s]
  std::vector<double> steps;
  steps.reserve(readings_.size());
  for (std::size_t n = 1; n < readings_.size(); ++n) steps.push_back(readings_[n].time - readings_[n - 1].time);
  std::erase_if(steps, [](double step) { return !(step >= kMinStep && step <= kMaxStep); });
  if (steps.empty()) return asked;
  const auto middle = steps.begin() + std::ptrdiff_t(steps.size() / 2);
  std::nth_element(steps.begin(), middle, steps.end());
  return std::abs(*middle / asked - 1) > kInexact ? *middle : asked;
}

void PlaybackDevice::begin_run(const RunOptions& /*options*/) { next_ = 0; }

bool PlaybackDevice::read(DeviceState& state) noexcept {
  if (next_ >= readings_.size()) return false;
  state = readings_[next_++];
  return true;
}

Wrench PlaybackDevice::write(const Wrench& wrench) noexcept { return wrench; }  // a recording does not respond

}  // namespace hapticut
