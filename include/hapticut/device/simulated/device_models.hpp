// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>
#include <string_view>

#include "hapticut/core/device_state.hpp"

/// @file
/// Mechanical models of devices and of the hand that holds them, for the mock device and the closed-loop bench.
namespace hapticut {

/// A device as mechanics sees it, the same along every axis: an apparent mass at the tip with viscous and dry friction,
/// read through an encoder.
struct DeviceModel {
  std::string_view name;               ///< what `device_model` is asked for
  double mass = 0;                     ///< [kg] apparent at the tip
  double damping = 0;                  ///< [N·s/m]
  double dry_friction = 0;             ///< [N] Coulomb
  double encoder_step = 0;             ///< [m]
  double peak_force = 0;               ///< [N]
  double continuous_force = 0;         ///< [N]
  double rendered_stiffness = 0;       ///< [N/m] greatest that it is said to render
  double rendered_damping = 0;         ///< [N·s/m] greatest that it is said to render
  double rotational_inertia = 2e-5;    ///< [kg·m^2] of the gimbal
  double rotational_damping = 2e-4;    ///< [N·m·s/rad]
  double peak_torque = 0;              ///< [N·m] 0: the gimbal has no motors
  double workspace_half_width = 0.08;  ///< [m] of the cube around the origin
};

/// The presets `touch`, `premium15`, `premium6dof` and `omega`: published data where there are any; the omega is a
/// guess of its class (docs/devices.md).
[[nodiscard]] std::span<const DeviceModel> device_models();

/// The preset of that name.  @throws Error that lists the names there are
[[nodiscard]] const DeviceModel& device_model(std::string_view name);

/// What such a device would say about itself.
[[nodiscard]] DeviceCapabilities capabilities(const DeviceModel& model);

/// A hand: a mass on a spring and a damper to where it wants to be. Bonded to the stylus (`pad_stiffness` 0), or behind
/// the soft pad of the fingers.
struct HandModel {
  std::string_view name;         ///< what `hand_model` is asked for
  double mass = 0;               ///< [kg]
  double damping = 0;            ///< [N·s/m]
  double stiffness = 0;          ///< [N/m] towards the set point
  double pad_stiffness = 0;      ///< [N/m] between stylus and hand; 0: bonded
  double pad_damping = 0;        ///< [N·s/m]
  double inertia = 0;            ///< [kg·m^2] that the fingers add to the gimbal
  double angular_damping = 0;    ///< [N·m·s/rad]
  double angular_stiffness = 0;  ///< [N·m/rad] towards the orientation of the set point
};

/// The presets `released`, `light`, `nominal`, `firm`, and with the pad of the fingers `light-pad`, `nominal-pad`,
/// `firm-pad`.
[[nodiscard]] std::span<const HandModel> hand_models();

/// The preset of that name.  @throws Error that lists the names there are
[[nodiscard]] const HandModel& hand_model(std::string_view name);

}  // namespace hapticut
