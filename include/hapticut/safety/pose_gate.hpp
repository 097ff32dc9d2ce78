// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>

#include "hapticut/core/description.hpp"
#include "hapticut/core/device_state.hpp"
#include "hapticut/safety/safety_log.hpp"

namespace hapticut {

/// What a reading must be to be believed.
struct PoseGateOptions {
  double fastest = 2.0;
  double max_angular_speed = 30;
  double workspace_margin = 0.05;
  double rotation_tolerance = 1e-3;
  double hold = 20e-3;
  double frozen = 30e-3;
  double frozen_rotation = 0.1;
  double frozen_speed = 5e-3;
};

constexpr auto fields_of(Of<PoseGateOptions>) {
  using O = PoseGateOptions;
  return std::tuple{
      field("fastest", &O::fastest, "m/s", Range::positive(), "a hand with a stylus reaches 1 to 2"),
      field("max_angular_speed", &O::max_angular_speed, "rad/s", Range::positive(), "the same of its turning"),
      field("workspace_margin", &O::workspace_margin, "m", Range::not_negative(),
            "beyond the device's own box that is still believed"),
      field("rotation_tolerance", &O::rotation_tolerance, "1", Range::between(0, 0.1),
            "of the entries of R R^T - 1; inexact ones are made exact"),
      field("hold", &O::hold, "s", Range::between(1e-3, 50e-3), "without a good reading after which the gate gives up"),
      field("frozen", &O::frozen, "s", Range::between(2e-3, 1),
            "of a position that stands still bit by bit while others move"),
      field("frozen_rotation", &O::frozen_rotation, "rad", Range::limit(),
            "within 0.1 s that contradict a position that stands still"),
      field("frozen_speed", &O::frozen_speed, "m/s", Range::limit(),
            "reported speed that contradicts a position that stands still"),
  };
}

/// The first stage of the safety pipeline: lets plausible readings through, holds the last good one in place of others.
/// @realtime no allocation, no lock
class PoseGate {
 public:
  enum class Verdict : std::uint8_t {
    accepted,  ///< the reading is good
    held,      ///< the last good pose stands in for it
    lost,      ///< too many bad ones in a row, or a frozen position: nothing can be said about the pose
  };

  /// @throws Error when an option is out of range
  PoseGate(const DeviceCapabilities& capabilities, const PoseGateOptions& options);

  /// Judges a reading.
  /// @param dt  [s] since the last reading, that a hand had for its way
  Verdict check(const DeviceState& reading, double dt, SafetyLog& log) noexcept;

  /// The reading to go on with: the last accepted one, its velocity zero when held, `valid` false when lost.
  [[nodiscard]] const DeviceState& state() const { return state_; }

  /// Forgets the past: the next plausible pose is taken wherever it is.
  void restart() noexcept;

 private:
  [[nodiscard]] std::optional<SafetyEvent> objection(const DeviceState& reading, double& value) noexcept;
  [[nodiscard]] bool is_frozen(const DeviceState& reading, double dt) noexcept;

  PoseGateOptions options_;
  Vec3 low_, high_;
  bool bounded_;
  DeviceState state_;
  bool started_ = false;
  double elapsed_ = 0;             // [s] that a hand had for the way from the last good pose
  double bad_ = 0;                 // [s] since the last good reading
  std::optional<double> resting_;  // [s] since the orientation of a resting stylus was looked at
  double contradicted_ = 0;        // [s] that the position has stood still while others moved
  Pose X_BS_still_;
};

}  // namespace hapticut
