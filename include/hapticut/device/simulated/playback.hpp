// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "hapticut/device/device.hpp"

namespace hapticut {

/// A simulated device that repeats recorded readings, one per tick, independent of the force. The readings keep their
/// own times and sequence numbers, so that the guard sees the same late ticks.
///
/// `open_device("replay:FILE")` makes one from a recording: see hapticut/io/recording/playback.hpp.
class PlaybackDevice : public PolledDevice {
 public:
  /// @throws Error when there are no readings
  PlaybackDevice(std::vector<DeviceState> readings, const DeviceCapabilities& capabilities,
                 std::string name = "playback");

  [[nodiscard]] std::size_t size() const { return readings_.size(); }  ///< number of readings

 protected:
  void begin_run(const RunOptions& options) override;
  [[nodiscard]] double choose_period(double asked) override;
  bool read(DeviceState& state) noexcept override;
  Wrench write(const Wrench& wrench) noexcept override;
  [[nodiscard]] bool is_simulated() const override { return true; }

 private:
  std::vector<DeviceState> readings_;
  std::size_t next_ = 0;
};

}  // namespace hapticut
