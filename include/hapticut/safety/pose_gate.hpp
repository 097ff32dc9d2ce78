// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>

#include "hapticut/core/description.hpp"
#include "hapticut/safety/device_state.hpp"
#include "hapticut/safety/safety_log.hpp"

namespace hapticut {

/// Limits of a plausible reading.
struct PoseGateOptions {
  double max_speed = 2.0;          ///< [m/s] largest speed of the hand; with a stylus it reaches 1 to 2
  double max_angular_speed = 30;   ///< [rad/s] largest angular speed of the hand
  double workspace_margin = 0.05;  ///< [m] around the device's own workspace that still counts as plausible
  /// [1] largest error of the entries of R R^T - 1; within it the rotation is made orthonormal
  double rotation_tolerance = 1e-3;
  double hold = 20e-3;  ///< [s] time without a good reading after which the pose counts as lost
  /// [s] time for which a position may be exactly constant while rotation or speed contradict it
  double frozen = 30e-3;
  double frozen_rotation = 0.1;  ///< [rad] rotation within 0.1 s that contradicts a constant position
  double frozen_speed = 5e-3;    ///< [m/s] reported speed that contradicts a constant position
};

constexpr auto fields_of(Of<PoseGateOptions>) {
  using O = PoseGateOptions;
  return std::tuple{
      field("max_speed", &O::max_speed, "m/s", Range::positive(),
            "largest speed of the hand; with a stylus it reaches 1 to 2"),
      field("max_angular_speed", &O::max_angular_speed, "rad/s", Range::positive(),
            "largest angular speed of the hand"),
      field("workspace_margin", &O::workspace_margin, "m", Range::not_negative(),
            "around the device's own workspace that still counts as plausible"),
      field("rotation_tolerance", &O::rotation_tolerance, "1", Range::between(0, 0.1),
            "largest error of the entries of R R^T - 1; within it the rotation is made orthonormal"),
      field("hold", &O::hold, "s", Range::between(1e-3, 50e-3),
            "time without a good reading after which the pose counts as lost"),
      field("frozen", &O::frozen, "s", Range::between(2e-3, 1),
            "time for which a position may be exactly constant while rotation or speed contradict it"),
      field("frozen_rotation", &O::frozen_rotation, "rad", Range::limit(),
            "rotation within 0.1 s that contradicts a constant position"),
      field("frozen_speed", &O::frozen_speed, "m/s", Range::limit(),
            "reported speed that contradicts a constant position"),
  };
}

/// The first stage of the safety pipeline: passes plausible readings on, and replaces the others by the last good one.
/// @realtime no allocation, no lock
class PoseGate {
 public:
  enum class Verdict : std::uint8_t {
    accepted,  ///< the reading is good
    repeated,  ///< the device has no newer reading; the last one is used
    held,      ///< the last good pose replaces it
    lost,      ///< too many bad readings in a row, or a frozen position: the pose is unknown
  };

  /// @throws Error when an option is out of range
  PoseGate(const DeviceCapabilities& capabilities, const PoseGateOptions& options);

  /// Checks a reading.
  /// @param dt  [s] since the last reading, in which the hand could move
  Verdict check(const DeviceState& reading, double dt, SafetyLog& log) noexcept;

  /// The reading to compute with: the last accepted one. Its velocity is zero when repeated or held, `valid` is false
  /// when lost.
  [[nodiscard]] const DeviceState& state() const { return state_; }

  /// Clears the memory: the next plausible pose is accepted wherever it is.
  void restart() noexcept;

 private:
  [[nodiscard]] std::optional<SafetyEvent> objection(const DeviceState& reading, double& value) noexcept;
  [[nodiscard]] bool is_frozen(const DeviceState& reading, double dt) noexcept;

  PoseGateOptions options_;
  Vec3 low_, high_;
  bool bounded_;
  DeviceState state_;
  bool started_ = false;
  double elapsed_ = 0;             // [s] since the last good pose, in which the hand could move
  double bad_ = 0;                 // [s] since the last good reading
  std::optional<double> resting_;  // [s] since the orientation of a resting stylus was stored
  double contradicted_ = 0;        // [s] for which the position was constant in contradiction
  Pose X_BS_still_;
};

}  // namespace hapticut
