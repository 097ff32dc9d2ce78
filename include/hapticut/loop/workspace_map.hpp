// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "hapticut/core/description.hpp"
#include "hapticut/safety/device_state.hpp"
#include "hapticut/simulation/coupling.hpp"

namespace hapticut {

/// How the device's workspace maps to the world.
struct WorkspaceMapOptions {
  Pose X_WB;                ///< pose of the device's base in the world
  double scale = 1;         ///< [1] metres in the world per metre of the hand
  double force_scale = 1;   ///< [1] newtons at the hand per newton in the world; a value equal to scale preserves power
  double torque_scale = 1;  ///< [1] torque at the hand per torque in the world; 1 preserves power
  Pose X_SH;                ///< pose of the tool's handle in the stylus frame; its translation is not scaled
  bool orientation = true;  ///< whether the tool rotates with the hand; false for devices of three degrees of freedom
};

constexpr auto fields_of(Of<WorkspaceMapOptions>) {
  using O = WorkspaceMapOptions;
  return std::tuple{
      field("X_WB", &O::X_WB, "pose of the device's base in the world"),
      field("scale", &O::scale, "1", Range::between(0.01, 100), "metres in the world per metre of the hand"),
      field("force_scale", &O::force_scale, "1", Range::positive(),
            "newtons at the hand per newton in the world; a value equal to scale preserves power"),
      field("torque_scale", &O::torque_scale, "1", Range::positive(),
            "torque at the hand per torque in the world; 1 preserves power"),
      field("X_SH", &O::X_SH, "pose of the tool's handle in the stylus frame; its translation is not scaled"),
      field("orientation", &O::orientation,
            "whether the tool rotates with the hand; false for devices of three degrees of freedom"),
  };
}

/// Converts the gains of a coupling from the hand (`felt`) to the world. Stiffness, damping and mass are divided by
/// scale * force_scale, the force limit by force_scale, and all angular gains by torque_scale.
[[nodiscard]] CouplingGains gains_in_world(const CouplingGains& felt, const WorkspaceMapOptions& map) noexcept;

/// Maps poses from a device to the world, and forces back, with a scale and a clutch.
///
/// Frames: B base of the device, S stylus, W world, H handle of the tool.
///
///     p_WS = p_home + s R_WB (p_BS - p_latch)
///     R_WS = R_WB (R_BS R_latch^T) R_WB^T R_home
///     X_WH = X_WS X_SH
///
/// Home and latch are the poses of the stylus in the world and in the base when the clutch was last engaged, so that
/// engaging moves nothing. The scale acts on translations only. While the clutch is open, the tool keeps its pose and
/// the hand feels nothing.
///
/// The stiffness at the device is `scale x force_scale` times that in the world; compare the stiffness at the device
/// with the device's limits. After every change of the map the guard must wait until the tool is free:
/// `Device::interrupt(reclutched)`.
/// @realtime no allocation, no lock, except in the constructor
class WorkspaceMap {
 public:
  /// @throws Error when a scale is not a finite number > 0, or a rotation is invalid
  explicit WorkspaceMap(const WorkspaceMapOptions& options);

  /// Opens the clutch: the tool keeps its pose from now on.
  void disengage(const Pose& X_BS) noexcept;

  /// Closes the clutch at the present pose of the hand. Nothing moves.
  void engage(const Pose& X_BS) noexcept;

  /// Moves the tool to a pose in the world. The hand keeps its pose.
  void place(const Pose& X_BS, const Pose& X_WH) noexcept;

  /// Changes the scale. Nothing moves.  @return false, without a change, when the scale is out of range
  bool set_scale(double scale, const Pose& X_BS) noexcept;

  [[nodiscard]] bool engaged() const { return engaged_; }
  [[nodiscard]] double scale() const { return options_.scale; }  ///< [1] the present scale, world over hand
  [[nodiscard]] const WorkspaceMapOptions& options() const { return options_; }  ///< the present options

  /// The pose X_WH of the handle.
  [[nodiscard]] Pose to_world(const Pose& X_BS) const noexcept;

  /// The velocity of the handle point Ho, in W.
  [[nodiscard]] Twist to_world(const Pose& X_BS, const Twist& V_BS) const noexcept;

  /// Converts a wrench on the tool about Ho, in W, to the wrench on the stylus about its point, in B.
  [[nodiscard]] Wrench to_device(const Pose& X_BS, const Wrench& wrench) const noexcept;

  /// [N/m] The stiffness at the hand of a stiffness in the world.
  [[nodiscard]] double felt_stiffness(double stiffness) const {
    return options_.scale * options_.force_scale * stiffness;
  }

 private:
  [[nodiscard]] Pose stylus_in_world(const Pose& X_BS) const noexcept;
  void latch(const Pose& X_BS, const Pose& X_WS) noexcept;

  WorkspaceMapOptions options_;
  Pose X_WS_home_;   // pose of the stylus in W when it was latched
  Pose X_BS_latch_;  // pose of the stylus in B when it was latched
  bool engaged_ = true;
};

}  // namespace hapticut
