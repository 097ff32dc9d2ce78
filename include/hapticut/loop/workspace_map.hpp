// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "hapticut/core/description.hpp"
#include "hapticut/core/device_state.hpp"
#include "hapticut/simulation/coupling.hpp"

namespace hapticut {

/// How the hand's space lies in the world.
struct WorkspaceMapOptions {
  Pose X_WB;
  double scale = 1;
  double force_scale = 1;
  double torque_scale = 1;
  Pose X_SH;
  bool orientation = true;
};

constexpr auto fields_of(Of<WorkspaceMapOptions>) {
  using O = WorkspaceMapOptions;
  return std::tuple{
      field("X_WB", &O::X_WB, "pose of the device's base in the world: where its origin is, where it looks"),
      field("scale", &O::scale, "1", Range::between(0.01, 100), "metres in the world per metre of the hand"),
      field("force_scale", &O::force_scale, "1", Range::positive(),
            "newtons at the hand per newton in the world; scale preserves power"),
      field("torque_scale", &O::torque_scale, "1", Range::positive(), "the same for torques; 1 preserves power"),
      field("X_SH", &O::X_SH, "pose of the tool's handle in the stylus frame; its lever is not scaled"),
      field("orientation", &O::orientation,
            "false for devices of three degrees of freedom: the tool keeps its orientation"),
  };
}

/// The gains in the world of a coupling that shall feel at the hand as `felt`: stiffness, damping and mass are smaller
/// by scale and force_scale, the limits by force_scale, and what turns by torque_scale.
[[nodiscard]] CouplingGains gains_in_world(const CouplingGains& felt, const WorkspaceMapOptions& map) noexcept;

/// Takes poses from a device to the world and forces back, with a scale and a clutch.
///
/// Frames: B base of the device, S stylus, W world, H handle of the tool.
///
///     p_WS = p_home + s R_WB (p_BS - p_latch)
///     R_WS = R_WB (R_BS R_latch^T) R_WB^T R_home
///     X_WH = X_WS X_SH
///
/// Home and latch are the poses of stylus in world and base when the clutch was engaged last, so that engaging moves
/// nothing (the scale acts on translations only). While the clutch is open the tool stays where it is and the hand
/// feels nothing.
///
/// The stiffness that the device feels is `scale x force_scale x` that of the world: check that one against its limits.
/// After every change of the map the guard must wait until the tool is free: `Device::interrupt(reclutched)`.
/// @realtime no allocation, no lock, but for the constructor
class WorkspaceMap {
 public:
  /// @throws Error when a scale is not a finite number > 0 or the rotation is not a rotation
  explicit WorkspaceMap(const WorkspaceMapOptions& options);

  /// Opens the clutch: from now on the tool stays at its pose.
  void disengage(const Pose& X_BS) noexcept;

  /// Closes the clutch where the hand is now; nothing moves.
  void engage(const Pose& X_BS) noexcept;

  /// Moves the tool to a pose in the world; the hand stays where it is.
  void place(const Pose& X_BS, const Pose& X_WH) noexcept;

  /// Another scale from here on; nothing moves.  @return false, and nothing changes, when it is out of range
  bool set_scale(double scale, const Pose& X_BS) noexcept;

  [[nodiscard]] bool engaged() const { return engaged_; }
  [[nodiscard]] double scale() const { return options_.scale; }                  ///< [1] world over hand, as it is now
  [[nodiscard]] const WorkspaceMapOptions& options() const { return options_; }  ///< as they are now

  /// X_WH, the pose of the handle.
  [[nodiscard]] Pose to_world(const Pose& X_BS) const noexcept;

  /// Velocity of the handle point Ho, in W.
  [[nodiscard]] Twist to_world(const Pose& X_BS, const Twist& stylus) const noexcept;

  /// The wrench on the stylus about its point, in B, of a wrench on the tool about Ho, in W.
  [[nodiscard]] Wrench to_device(const Pose& X_BS, const Wrench& tool) const noexcept;

  /// [N/m] that the hand feels of a stiffness in the world.
  [[nodiscard]] double felt_stiffness(double world) const { return options_.scale * options_.force_scale * world; }

 private:
  [[nodiscard]] Pose stylus_in_world(const Pose& X_BS) const noexcept;
  void latch(const Pose& X_BS, const Pose& X_WS) noexcept;

  WorkspaceMapOptions options_;
  Pose X_WS_home_;   // of the stylus, in W
  Pose X_BS_latch_;  // of the stylus, in B
  bool engaged_ = true;
};

}  // namespace hapticut
